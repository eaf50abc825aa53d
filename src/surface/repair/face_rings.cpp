#include "surface/repair/face_rings.hpp"

#include <algorithm>

#include "surface/planar/triangulator.hpp"
#include "surface/repair/point_order.hpp"

namespace plumb::surface {

std::optional<std::vector<TriangleMesh::Triangle>> triangles_within(std::span<const Point3> points,
                                                                    std::span<const RingOfVertices> rings, Look look,
                                                                    Sign turn) {
  std::vector<std::uint32_t> vertices;
  for (const RingOfVertices& ring : rings) vertices.insert(vertices.end(), ring.begin(), ring.end());
  const auto before = [&](std::uint32_t l, std::uint32_t r) {
    return comes_before(points[l], points[r]) || (points[l] == points[r] && l < r);
  };
  std::ranges::sort(vertices, before);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<Point2> seen;
  for (const std::uint32_t v : vertices) seen.push_back(projected(look, points[v]));
  const auto number = [&](std::uint32_t v) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(vertices, v, before) - vertices.begin());
  };
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (const RingOfVertices& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i)
      edges.push_back({number(ring[i]), number(ring[(i + 1) % ring.size()])});
  auto made = triangulator_of(seen);
  for (std::uint32_t i = 0; i < seen.size(); ++i)
    if (made.same(i) != i) return {};
  if (made.constrain(edges)) return {};
  const Triangles& t = made.triangles();
  const std::vector<std::int32_t> windings = made.windings();
  const std::int32_t once = turn == Sign::positive ? 1 : -1;
  std::vector<TriangleMesh::Triangle> within;
  for (HalfEdge e = 0; e < t.end(); e += 4) {
    const std::int32_t around = windings[e / 4];
    if (around == 0) continue;
    if (around != once) return {};
    const auto label = [&](HalfEdge corner) { return vertices[made.points().label(t.origin(corner))]; };
    within.push_back({label(e), label(e + 1), label(e + 2)});
    if (once < 0) std::swap(within.back()[1], within.back()[2]);
  }
  return within;
}

}  // namespace plumb::surface
