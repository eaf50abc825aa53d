// Which triangles of a plane do closed rings wind around, and how often?
//
// Laws: each triangle around which the winding number is not zero is told once, counterclockwise, by numbers of points:
// those of the constrained Delaunay triangulation of all points, where the rings' edges are constraints.  Nothing is
// told where edges cross between their ends.
// Source: RTCD 12.5.1.
// Cost: n log n expected, and a triangulation's signs.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"
#include "surface/planar/triangulator.hpp"

namespace plumb::surface {

struct WoundTriangle {
  TriangleMesh::Triangle corners;
  std::int32_t winding;
};

/// No two points are equal.
template <class Point>
std::optional<std::vector<WoundTriangle>> wound_triangles(std::span<const Point> points,
                                                          std::span<const std::array<std::uint32_t, 2>> edges) {
  auto made = triangulator_of(points);
  if (made.constrain(edges)) return {};
  const Triangles& t = made.triangles();
  const std::vector<std::int32_t> windings = made.windings();
  std::vector<WoundTriangle> wound;
  for (HalfEdge e = 0; e < t.end(); e += 4) {
    if (windings[e / 4] == 0) continue;
    const auto label = [&](HalfEdge at) { return made.points().label(t.origin(at)); };
    wound.push_back({{label(e), label(e + 1), label(e + 2)}, windings[e / 4]});
  }
  return wound;
}

}  // namespace plumb::surface
