#include "surface/repair/face_rings.hpp"

#include <algorithm>

#include "surface/planar/triangulator.hpp"
#include "surface/repair/point_order.hpp"

namespace plumb::surface {
namespace {

/// Is an edge of the rings divided, because another vertex lies on it?  What is beside it would not be divided as well.
bool divides_any(const Triangulator<GivenPoints>& made, std::span<const std::array<std::uint32_t, 2>> edges) {
  const Triangles& t = made.triangles();
  std::vector<std::array<std::uint32_t, 2>> whole;
  for (HalfEdge first = 0; first < t.end(); first += 4) {
    if (t.is_ghost(first)) continue;
    for (HalfEdge h = first; h < first + 3; ++h) {
      if (!t.is_constrained(h)) continue;
      const HalfEdge after = h == first + 2 ? first : h + 1;
      const std::uint32_t a = made.points().label(t.origin(h)), b = made.points().label(t.origin(after));
      whole.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::ranges::sort(whole);
  return !std::ranges::all_of(edges, [&](const std::array<std::uint32_t, 2>& e) {
    return std::ranges::binary_search(whole, std::array{std::min(e[0], e[1]), std::max(e[0], e[1])});
  });
}

}  // namespace

std::optional<std::vector<RegionOfRings>> regions_of_rings(std::span<const Point3> points,
                                                           std::span<const RingOfVertices> rings, Look look) {
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
  std::vector<std::uint32_t> ring_of;  // each edge
  for (std::uint32_t r = 0; r < rings.size(); ++r) {
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      edges.push_back({number(rings[r][i]), number(rings[r][(i + 1) % rings[r].size()])});
      ring_of.push_back(r);
    }
  }
  auto made = triangulator_of(seen);
  for (std::uint32_t i = 0; i < seen.size(); ++i)
    if (made.same(i) != i) return {};
  if (made.constrain(edges) || divides_any(made, edges)) return {};
  const Triangles& t = made.triangles();
  const std::vector<std::int32_t> windings = made.windings();
  std::vector<RegionOfRings> regions;
  std::vector<std::uint8_t> passed(t.end() / 4);
  std::vector<HalfEdge> pending;
  for (HalfEdge start = 0; start < t.end(); start += 4) {
    if (passed[start / 4] != 0 || windings[start / 4] == 0) continue;
    RegionOfRings region{windings[start / 4], {}, {}};
    passed[start / 4] = 1;
    pending.assign(1, start);
    while (!pending.empty()) {
      const HalfEdge e = pending.back();
      pending.pop_back();
      const auto label = [&](HalfEdge corner) { return vertices[made.points().label(t.origin(corner))]; };
      region.triangles.push_back({label(e), label(e + 1), label(e + 2)});
      for (HalfEdge h = e; h < e + 3; ++h) {
        const HalfEdge beyond = Triangles::first_of(t.twin(h));
        if (const std::uint32_t constraint = t.mark(h).constraint; constraint != none) {
          region.rings.push_back(ring_of[constraint]);
        } else if (passed[beyond / 4] == 0) {
          passed[beyond / 4] = 1;
          pending.push_back(beyond);
        }
      }
    }
    std::ranges::sort(region.rings);
    region.rings.erase(std::unique(region.rings.begin(), region.rings.end()), region.rings.end());
    regions.push_back(std::move(region));
  }
  return regions;
}

void turn_over(std::span<TriangleMesh::Triangle> triangles) {
  for (TriangleMesh::Triangle& t : triangles) std::swap(t[1], t[2]);
}

std::optional<std::vector<TriangleMesh::Triangle>> triangles_within(std::span<const Point3> points,
                                                                    std::span<const RingOfVertices> rings, Look look,
                                                                    Sign turn) {
  const auto regions = regions_of_rings(points, rings, look);
  if (!regions) return {};
  std::vector<TriangleMesh::Triangle> within;
  for (const RegionOfRings& region : *regions) {
    if (region.winding != (turn == Sign::positive ? 1 : -1)) return {};
    within.insert(within.end(), region.triangles.begin(), region.triangles.end());
  }
  if (turn == Sign::negative) turn_over(within);
  return within;
}

}  // namespace plumb::surface
