// Do two boxes overlap, as the broad phase is asked: with or without those that only touch?
//
// Laws: with touching relate != disjoint, without it relate == overlapping, of boxes that are not empty.
// Cost: comparisons of the numbers as they are, doubles or floats: they are exact.
#pragma once

#include "plumb/space/pairs/float_boxes.hpp"

namespace plumb::space {

/// On one axis.  Where touching does not count, ends must pass one another, or both intervals be the same point.
template <class Number>
constexpr bool intervals_meet(Number a_min, Number a_max, Number b_min, Number b_max, bool touching) {
  if (touching) return (a_min <= b_max) & (b_min <= a_max);
  return ((a_min < b_max) & (b_min < a_max)) | ((a_min == a_max) & (b_min == b_max) & (a_min == b_min));
}

constexpr bool boxes_meet(const Aabb2& a, const Aabb2& b, bool touching) {
  return intervals_meet(a.min.x, a.max.x, b.min.x, b.max.x, touching) &&
         intervals_meet(a.min.y, a.max.y, b.min.y, b.max.y, touching);
}
constexpr bool boxes_meet(const Aabb3& a, const Aabb3& b, bool touching) {
  return intervals_meet(a.min.x, a.max.x, b.min.x, b.max.x, touching) &&
         intervals_meet(a.min.y, a.max.y, b.min.y, b.max.y, touching) &&
         intervals_meet(a.min.z, a.max.z, b.min.z, b.max.z, touching);
}
constexpr bool boxes_meet(const FloatBox2& a, const FloatBox2& b, bool touching) {
  return boxes_meet(widened(a), widened(b), touching);
}
constexpr bool boxes_meet(const FloatBox3& a, const FloatBox3& b, bool touching) {
  return boxes_meet(widened(a), widened(b), touching);
}

}  // namespace plumb::space
