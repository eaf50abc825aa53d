// How does a polygon lie to any other figure with straight edges, or to another polygon?
//
// Laws: those of query/overlap/overlap.hpp.  Vertices that are not exactly in one plane throw InvalidShape, of which no surface
// is known.
// Method: what of the other figure lies in the polygon's plane is a convex set there, or another polygon, or both meet
// on a line: query/overlap/polygon_region.hpp.
// Source: RTCD 5.4.1.
// Cost: GMP; some 10 us and more, quadratic in the edges.
#pragma once

#include <string_view>

#include "query/convex/flat_view.hpp"
#include "query/convex/trapezoids.hpp"

namespace plumb::query {

/// One of them is a polygon; their numbers are finite.
Relation relate_polygon(std::string_view function, const FlatView& a, const FlatView& b);

/// A polygon and any convex set.
Relation relate_convex(std::string_view function, const FlatView& polygon, const FlatSet& other);

/// The chains of a polygon; throws where they do not lie in one plane.
ExactChains exact_chains(std::string_view function, const FlatView& polygon);
Relation relate_chains(const ExactChains& a, const ExactChains& b);
/// Without `of_inside` what they have in common is on the boundary of b.
Relation relate_chains(const ExactChains& a, const FlatSet& b, bool of_inside = true);

}  // namespace plumb::query
