#include "surface/repair/island_filling.hpp"

#include <algorithm>

#include "surface/repair/face_rings.hpp"

namespace plumb::surface {
namespace {

/// Loops of one plane, with three points that span it.
struct LoopsOfPlane {
  std::array<Point3, 3> span;
  std::vector<std::uint32_t> loops;
};

std::vector<LoopsOfPlane> loops_by_plane(std::span<const Point3> points,
                                         std::span<const std::vector<std::uint32_t>> loops) {
  std::vector<LoopsOfPlane> planes;
  for (std::uint32_t i = 0; i < loops.size(); ++i) {
    const auto at = [&](std::size_t k) -> const Point3& { return points[loops[i][k]]; };
    const PlaneOfPoints plane = plane_of_points(loops[i].size(), at);
    if (plane.dimension != 2) continue;
    const std::array span{at(plane.span[0]), at(plane.span[1]), at(plane.span[2])};
    const auto is_same = [&](const LoopsOfPlane& other) {
      const Point3 &a = other.span[0], &b = other.span[1], &c = other.span[2];
      return std::ranges::all_of(span, [&](const Point3& p) { return orient3d(a, b, c, p) == Sign::zero; });
    };
    const auto known = std::ranges::find_if(planes, is_same);
    if (known == planes.end()) {
      planes.push_back({span, {i}});
    } else {
      known->loops.push_back(i);
    }
  }
  return planes;
}

}  // namespace

std::vector<FilledIslands> island_fillings(std::span<const Point3> points,
                                           std::span<const std::vector<std::uint32_t>> loops) {
  std::vector<FilledIslands> filled;
  for (const LoopsOfPlane& plane : loops_by_plane(points, loops)) {
    if (plane.loops.size() < 2) continue;
    const auto& [a, b, c] = plane.span;
    std::vector<RingOfVertices> rings;
    for (const std::uint32_t i : plane.loops) rings.emplace_back(loops[i]);
    auto regions = regions_of_rings(points, rings, look_at_plane(a, b, c));
    if (!regions) continue;
    const auto is_simple = [](const RegionOfRings& r) { return r.winding == 1 || r.winding == -1; };
    if (!std::ranges::all_of(*regions, is_simple)) continue;
    std::vector<int> regions_beside(rings.size());
    for (const RegionOfRings& r : *regions)
      for (const std::uint32_t ring : r.rings) ++regions_beside[ring];
    for (RegionOfRings& r : *regions) {
      const auto is_its_own = [&](std::uint32_t ring) { return regions_beside[ring] == 1; };
      if (r.rings.size() < 2 || !std::ranges::all_of(r.rings, is_its_own)) continue;
      if (r.winding < 0) turn_over(r.triangles);
      FilledIslands islands{{}, std::move(r.triangles)};
      for (const std::uint32_t ring : r.rings) islands.loops.push_back(plane.loops[ring]);
      filled.push_back(std::move(islands));
    }
  }
  return filled;
}

}  // namespace plumb::surface
