// Is a point on a segment, and neither of its ends?
//
// Cost: comparisons; three signs for a point in the segment's box.
#pragma once

#include <algorithm>

#include "plumb/certify/direction.hpp"

namespace plumb::surface {

inline bool is_strictly_between(const Point3& a, const Point3& p, const Point3& b) {
  const auto between = [](double from, double x, double to) {
    return std::min(from, to) <= x && x <= std::max(from, to);
  };
  return between(a.x, p.x, b.x) && between(a.y, p.y, b.y) && between(a.z, p.z, b.z) && p != a && p != b &&
         collinear(a, p, b);
}

}  // namespace plumb::surface
