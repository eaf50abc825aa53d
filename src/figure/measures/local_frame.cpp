#include "figure/measures/local_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "figure/measures/principal_axes.hpp"

namespace plumb::figure {

Vector3 LocalFrame::local(const Point3& p) const {
  const Vector3 d = figure::frame::scaled({p.x - middle.x, p.y - middle.y, p.z - middle.z}, -exponent);
  return {figure::frame::dot(d, axes[0]), figure::frame::dot(d, axes[1]), figure::frame::dot(d, axes[2])};
}

Vector3 LocalFrame::world_vector(const Vector3& v) const {
  const Vector3 sum =
      figure::frame::plus(figure::frame::plus(figure::frame::times(axes[0], v.x), figure::frame::times(axes[1], v.y)),
                          figure::frame::times(axes[2], v.z));
  return figure::frame::scaled(sum, exponent);
}

Point3 LocalFrame::world(const Vector3& along_axes) const {
  const Vector3 v = world_vector(along_axes);
  return {middle.x + v.x, middle.y + v.y, middle.z + v.z};
}

LocalFrame principal_frame(std::span<const Point3> points) {
  Point3 least = points[0], most = least;
  for (const Point3& p : points) {
    least = {std::min(least.x, p.x), std::min(least.y, p.y), std::min(least.z, p.z)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y), std::max(most.z, p.z)};
  }
  LocalFrame f{{std::midpoint(least.x, most.x), std::midpoint(least.y, most.y), std::midpoint(least.z, most.z)},
               0,
               {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}};
  const double half = std::max({most.x / 2 - least.x / 2, most.y / 2 - least.y / 2, most.z / 2 - least.z / 2});
  if (half == 0) return f;
  f.exponent = figure::frame::exponent(half);
  std::vector<Vector3> local;
  local.reserve(points.size());
  for (const Point3& p : points) local.push_back(f.local(p));
  f.axes = figure::frame::principal_axes(local);
  return f;
}

}  // namespace plumb::figure
