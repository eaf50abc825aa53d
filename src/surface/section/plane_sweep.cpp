#include "surface/section/plane_sweep.hpp"

#include <algorithm>
#include <tuple>

#include "space/bvh/parts.hpp"

namespace plumb::surface {

std::vector<std::vector<std::uint32_t>> planes_by_normal(std::span<const AnyPlane3> planes) {
  std::vector<std::vector<std::uint32_t>> runs;
  std::vector<std::uint32_t> with_normal;
  for (std::uint32_t i = 0; i < planes.size(); ++i) {
    if (std::holds_alternative<Plane3>(planes[i])) {
      with_normal.push_back(i);
    } else {
      runs.push_back({i});
    }
  }
  const auto key = [&](std::uint32_t i) {
    const auto& [n, offset] = std::get<Plane3>(planes[i]);
    return std::tuple(n.x, n.y, n.z, offset, i);
  };
  std::ranges::sort(with_normal, {}, key);
  const Vector3* last = nullptr;
  for (const std::uint32_t i : with_normal) {
    const Vector3& normal = std::get<Plane3>(planes[i]).normal;
    if (last == nullptr || !(normal == *last)) runs.emplace_back();
    runs.back().push_back(i);
    last = &normal;
  }
  return runs;
}

PlaneSweep::PlaneSweep(const TriangleMesh& mesh, std::span<const CutPlane* const> planes)
    : ranks_(mesh.vertices.size()), triangles_(planes.size()) {
  const auto rank = [&](std::size_t v) {
    const Point3& p = mesh.vertices[v];
    std::size_t above = 0, end = planes.size();
    Sign at_end = Sign::negative;  // each side is asked once
    while (above < end) {
      const std::size_t middle = above + (end - above) / 2;
      const Sign side = planes[middle]->side(p);
      if (side == Sign::positive) {
        above = middle + 1;
      } else {
        end = middle;
        at_end = side;
      }
    }
    std::size_t up_to = above + (at_end == Sign::zero ? 1 : 0);
    while (at_end == Sign::zero && up_to < planes.size() && planes[up_to]->side(p) == Sign::zero) ++up_to;
    ranks_[v] = {static_cast<std::uint32_t>(above), static_cast<std::uint32_t>(up_to)};
  };
  space::for_blocks(Execution::parallel, ranks_.size(), 1 << 10, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t v = from; v < to; ++v) rank(v);
  });
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const std::uint32_t lowest = std::min({ranks_[a].above, ranks_[b].above, ranks_[c].above});
    const std::uint32_t highest = std::max({ranks_[a].up_to, ranks_[b].up_to, ranks_[c].up_to});
    for (std::uint32_t plane = lowest; plane < highest; ++plane) triangles_[plane].push_back(t);
  }
}

}  // namespace plumb::surface
