// What is a box?  Axis-aligned ones in three representations, oriented ones, and rectangles in space.
//
// Laws: the closed sets that the numbers say.  An axis-aligned box with min > max in some axis is empty; of widths and
// half extents the magnitude counts.  An oriented box is the parallelepiped of its axes, orthonormal or not: all center
// + sum of t_i axes_i with |t_i| <= half_i; it may be flat, a segment or a point.
// Source: RTCD 4.2 (figure 4.3), 4.4, 4.5.
// Cost: none.
#pragma once

// First, so that what a compiler says of an older standard is short.
#include "plumb/predicates/standard.hpp"

// What is it made of?
#include <array>

#include "plumb/figure/basic/body.hpp"

namespace plumb {

struct Aabb2 {
  Point2 min, max;
  friend bool operator==(const Aabb2&, const Aabb2&) = default;
};
struct Aabb3 {
  Point3 min, max;
  friend bool operator==(const Aabb3&, const Aabb3&) = default;
};

/// Is there no point in it?  What is NaN makes none empty.
constexpr bool is_empty(const Aabb2& b) { return b.min.x > b.max.x || b.min.y > b.max.y; }
constexpr bool is_empty(const Aabb3& b) { return b.min.x > b.max.x || b.min.y > b.max.y || b.min.z > b.max.z; }

/// From min to min + widths, in real arithmetic.
struct AabbWidths3 {
  Point3 min;
  Vector3 widths;
  friend bool operator==(const AabbWidths3&, const AabbWidths3&) = default;
};

/// From center - half to center + half, in real arithmetic.
struct AabbCenter3 {
  Point3 center;
  Vector3 half;
  friend bool operator==(const AabbCenter3&, const AabbCenter3&) = default;
};

struct Obb2 {
  Point2 center;
  std::array<Vector2, 2> axes;
  Vector2 half;
  friend bool operator==(const Obb2&, const Obb2&) = default;
};
struct Obb3 {
  Point3 center;
  std::array<Vector3, 3> axes;
  Vector3 half;
  friend bool operator==(const Obb3&, const Obb3&) = default;
};

/// All center + t0 axes[0] + t1 axes[1] with |t_i| <= half_i.
struct Rectangle3 {
  Point3 center;
  std::array<Vector3, 2> axes;
  Vector2 half;
  friend bool operator==(const Rectangle3&, const Rectangle3&) = default;
};

template <class Take>
constexpr auto body(const Aabb2& s, Take take) {
  return take("aabb", part::corner("min", s.min), part::corner("max", s.max));
}
template <class Take>
constexpr auto body(const Aabb3& s, Take take) {
  return take("aabb", part::corner("min", s.min), part::corner("max", s.max));
}
template <class Take>
constexpr auto body(const AabbWidths3& s, Take take) {
  return take("aabb", part::corner("min", s.min), part::multiple("widths", s.widths));
}
template <class Take>
constexpr auto body(const AabbCenter3& s, Take take) {
  return take("aabb", part::place("center", s.center), part::multiple("half", s.half));
}
template <class Take>
constexpr auto body(const Obb2& s, Take take) {
  return take("obb", part::place("center", s.center), part::axis("axes", s.axes), part::multiple("half", s.half));
}
template <class Take>
constexpr auto body(const Obb3& s, Take take) {
  return take("obb", part::place("center", s.center), part::axis("axes", s.axes), part::multiple("half", s.half));
}
template <class Take>
constexpr auto body(const Rectangle3& s, Take take) {
  return take("rectangle", part::place("center", s.center), part::axis("axes", s.axes), part::multiple("half", s.half));
}

}  // namespace plumb
