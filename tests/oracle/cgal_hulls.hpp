// Which points does CGAL find extreme, and which are together on a facet?  Its hull over exact rationals.
//
// Source: CGAL 5.5's manual, convex_hull_3 and Exact_predicates_exact_constructions_kernel.
// Cost: microseconds a point.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"

namespace plumb::oracle {

/// The hull's vertices, each by its first place in the input, ascending, those left out that CGAL keeps within edges
/// and facets: of which all facets share another vertex.  For points that span space.
std::vector<std::uint32_t> hull_vertices(std::span<const Point3> points);

}  // namespace plumb::oracle
