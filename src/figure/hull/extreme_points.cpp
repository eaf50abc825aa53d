#include "figure/basic/finite_parts.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/figure/hull/hull3.hpp"

namespace plumb {

std::vector<std::uint32_t> extreme_points(std::span<const Point3> points, const Vector3& direction) {
  figure::require_finite_points("extreme_points", "points", points);
  require_finite_parts("extreme_points", std::array<std::string_view, 1>{"direction"}, direction);
  std::vector<std::uint32_t> farthest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Sign s = farthest.empty() ? Sign::zero : compare_along_direction(points[i], points[farthest[0]], direction);
    if (s == Sign::negative) continue;
    if (s == Sign::positive) farthest.clear();
    farthest.push_back(static_cast<std::uint32_t>(i));
  }
  return farthest;
}

}  // namespace plumb
