// What is straight?  Lines, rays and segments, as given: nothing is normalized.
//
// Laws: a line or ray of zero direction is its point; a segment of equal ends is that point.  Which end of a segment is
// named first does not matter to the set of points.
// Source: RTCD 3.5.
// Cost: none.
#pragma once

#include "plumb/figure/basic/body.hpp"

namespace plumb {

/// All point + t direction.
struct Line2 {
  Point2 point;
  Vector2 direction;
  friend bool operator==(const Line2&, const Line2&) = default;
};
struct Line3 {
  Point3 point;
  Vector3 direction;
  friend bool operator==(const Line3&, const Line3&) = default;
};

/// All origin + t direction with t >= 0.
struct Ray2 {
  Point2 origin;
  Vector2 direction;
  friend bool operator==(const Ray2&, const Ray2&) = default;
};
struct Ray3 {
  Point3 origin;
  Vector3 direction;
  friend bool operator==(const Ray3&, const Ray3&) = default;
};

struct Segment2 {
  Point2 a, b;
  friend bool operator==(const Segment2&, const Segment2&) = default;
};
struct Segment3 {
  Point3 a, b;
  friend bool operator==(const Segment3&, const Segment3&) = default;
};

template <class Take>
constexpr auto body(const Line2& s, Take take) {
  return take("line", part::place("point", s.point), part::axis("direction", s.direction));
}
template <class Take>
constexpr auto body(const Ray2& s, Take take) {
  return take("ray", part::place("origin", s.origin), part::axis("direction", s.direction));
}
template <class Take>
constexpr auto body(const Segment2& s, Take take) {
  return take("segment", part::place("a", s.a), part::place("b", s.b));
}
template <class Take>
constexpr auto body(const Line3& s, Take take) {
  return take("line", part::place("point", s.point), part::axis("direction", s.direction));
}
template <class Take>
constexpr auto body(const Ray3& s, Take take) {
  return take("ray", part::place("origin", s.origin), part::axis("direction", s.direction));
}
template <class Take>
constexpr auto body(const Segment3& s, Take take) {
  return take("segment", part::place("a", s.a), part::place("b", s.b));
}

}  // namespace plumb
