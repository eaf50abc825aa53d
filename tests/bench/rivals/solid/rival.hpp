// How long does CGAL take to unite two solids, by corefinement in doubles?
//
// Law: its kernel decides exactly and constructs in doubles (Epick), from the same bare arrays as ours.
// Source: CGAL's manual, "Polygon Mesh Processing", corefinement.
#pragma once

#include <optional>

#include "plumb/figure/basic/mesh.hpp"

namespace plumb::bench {

/// The number of triangles; nothing where it refuses the input or tells that it has no result.
std::optional<std::size_t> unite_by_cgal(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace plumb::bench
