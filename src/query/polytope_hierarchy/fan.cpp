// The normal is a guess in doubles, which holds no bound: the sum of the unit vectors to the neighbors.
#include "query/polytope_hierarchy/fan.hpp"

#include <algorithm>
#include <cmath>

#include "plumb/certify/direction.hpp"

namespace plumb::query::hierarchy {

std::optional<Vector3> fan_normal(std::span<const Point3> points, std::uint32_t vertex,
                                  std::span<const std::uint32_t> around) {
  if (around.size() < fewest_of_fan) return {};
  const Point3& from = points[vertex];
  Vector3 sum{0, 0, 0};
  for (const std::uint32_t v : around) {
    const Point3& p = points[v];
    const double x = p.x - from.x, y = p.y - from.y, z = p.z - from.z, length = std::hypot(x, y, z);
    sum = {sum.x + x / length, sum.y + y / length, sum.z + z / length};
  }
  if (!std::isfinite(sum.x + sum.y + sum.z)) return {};
  const auto is_before = [&](std::uint32_t v) {
    return compare_along_direction(points[v], from, sum) == Sign::positive;
  };
  if (!std::ranges::all_of(around, is_before)) return {};
  return sum;
}

}  // namespace plumb::query::hierarchy
