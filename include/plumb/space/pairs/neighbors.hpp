// Do two triangles of one mesh have more in common than the vertices that they share?
//
// Shared is what both name by the same index: nothing, a vertex, two vertices and the edge between them.
// Laws: (1) disjoint where the two closed triangles have no point in common but those of the shared vertex or edge; else
// relate's answer, touching or overlapping.  So neighbors that lie flat or at an angle are disjoint, those folded onto
// one another overlap.  (2) Triangles that name the same set of vertices are coincident, and overlap.  (3) Vertices of
// equal coordinates and different indices are not shared.  (4) Symmetric, and the same for every order of corners.
// (5) Triangles without area, with an index twice or with equal points, are the segments and points that they are.
// Coordinates must be finite; an index must name a vertex.
// Source: RTCD 5.2.10.
// Cost: two signs of orient3d for neighbors by a vertex, one for neighbors by an edge, where they are not coplanar; some
// microseconds for triangles without area.  Nothing is searched.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "plumb/arith/point.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

Relation relate_in_mesh(std::span<const Point3> vertices, const std::array<std::uint32_t, 3>& a,
                        const std::array<std::uint32_t, 3>& b);

}  // namespace plumb
