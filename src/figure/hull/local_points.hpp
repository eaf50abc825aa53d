// Where are the points, with their middle at the origin and of magnitude one?  For searches in doubles.
//
// Laws: directions among the points stay what they are, up to rounding; all results are finite.
// Cost: a few ns a point.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "figure/basic/frame.hpp"

namespace plumb::figure::frame {

/// All coordinates in [-1, 1]; equal points all become zero.
inline std::vector<Vector3> localized(std::span<const Point3> points) {
  std::vector<Vector3> local;
  local.reserve(points.size());
  double most = 0;
  for (const Point3& p : points) most = std::max({most, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  const int scale = -exponent(most) - 1;
  Vector3 least{1, 1, 1}, greatest{-1, -1, -1};
  for (const Point3& p : points) {
    const Vector3 q = scaled({p.x, p.y, p.z}, scale);
    local.push_back(q);
    least = {std::min(least.x, q.x), std::min(least.y, q.y), std::min(least.z, q.z)};
    greatest = {std::max(greatest.x, q.x), std::max(greatest.y, q.y), std::max(greatest.z, q.z)};
  }
  const Vector3 middle = times(plus(least, greatest), 0.5);
  const double extent = largest(minus(greatest, middle));
  const int grow = extent > 0 ? -exponent(extent) : 0;
  for (Vector3& q : local) q = scaled(minus(q, middle), grow);
  return local;
}

}  // namespace plumb::figure::frame
