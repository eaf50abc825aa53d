// Is a point on a segment and neither of its ends, or within a length of it beside its ends?
//
// Laws: exactly on it; or the foot of the perpendicular is strictly between the ends, and the distance at most the
// length.
// Cost: comparisons; three signs for a point in the segment's box, or two and a distance.
#pragma once

#include <algorithm>

#include "plumb/certify/compare_distance.hpp"
#include "plumb/certify/direction.hpp"

namespace plumb::surface {

inline bool is_strictly_between(const Point3& a, const Point3& p, const Point3& b) {
  const auto between = [](double from, double x, double to) {
    return std::min(from, to) <= x && x <= std::max(from, to);
  };
  return between(a.x, p.x, b.x) && between(a.y, p.y, b.y) && between(a.z, p.z, b.z) && p != a && p != b &&
         collinear(a, p, b);
}

inline bool runs_by(const Point3& a, const Point3& p, const Point3& b, double length) {
  return p != a && p != b && angle_sign(p, a, b) == Sign::positive && angle_sign(p, b, a) == Sign::positive &&
         compare_distance_to_segment(a, b, p, length) != Sign::positive;
}

}  // namespace plumb::surface
