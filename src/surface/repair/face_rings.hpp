// Which triangles lie within rings of a plane, or nearly of one, seen along an axis?
//
// Laws: the constrained Delaunay triangulation of the rings' edges, where they wind `turn` once around what is inside;
// it hangs on the points, not on the numbers of vertices.  Nothing where edges cross, where the rings wind around a
// place otherwise, or where two vertices are seen as one.
// Source: RTCD 12.5.1.
// Cost: n log n expected.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "figure/basic/plane_of_points.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb::surface {

using RingOfVertices = std::span<const std::uint32_t>;

std::optional<std::vector<TriangleMesh::Triangle>> triangles_within(std::span<const Point3> points,
                                                                    std::span<const RingOfVertices> rings, Look look,
                                                                    Sign turn);

}  // namespace plumb::surface
