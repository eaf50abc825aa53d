// Which triangles lie within rings of a plane, or nearly of one, seen along an axis?
//
// Laws: the constrained Delaunay triangulation of the rings' edges; it hangs on the points, not on the numbers of
// vertices.  Nothing where edges cross, where a vertex lies on an edge, or where two vertices are seen as one.
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

/// Triangles that no ring parts, around which the rings wind alike.
struct RegionOfRings {
  std::int32_t winding;
  std::vector<TriangleMesh::Triangle> triangles;  // counterclockwise as seen
  std::vector<std::uint32_t> rings;               // those that it is beside, ascending
};

/// Regions around which the rings wind, in no order.
std::optional<std::vector<RegionOfRings>> regions_of_rings(std::span<const Point3> points,
                                                           std::span<const RingOfVertices> rings, Look look);

/// What the rings wind around once, by `turn`; nothing where they wind otherwise around some place.
std::optional<std::vector<TriangleMesh::Triangle>> triangles_within(std::span<const Point3> points,
                                                                    std::span<const RingOfVertices> rings, Look look,
                                                                    Sign turn);

/// From the outside of the triangles to the inside.
void turn_over(std::span<TriangleMesh::Triangle> triangles);

}  // namespace plumb::surface
