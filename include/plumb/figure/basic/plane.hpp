// What has a normal?  Planes, halfspaces, slabs, and the intersections of halfspaces.
//
// Laws: the numbers are taken as they are: a normal need not have length one.  With a zero normal, normal . x is zero
// everywhere, and the set is all of space or nothing.  An intersection of no halfspaces is all of space.
// Source: RTCD 3.6, 4.6, 4.6.1, 3.7 (figure 3.16).
// Cost: none.
#pragma once

#include <vector>

#include "plumb/figure/basic/body.hpp"

namespace plumb {

/// All x with normal . x = offset.
struct Plane3 {
  Vector3 normal;
  double offset;
  friend bool operator==(const Plane3&, const Plane3&) = default;
};

/// The plane of three points: their affine hull, which is a line or a point where they span no plane.
struct ThreePointPlane3 {
  Point3 a, b, c;
  friend bool operator==(const ThreePointPlane3&, const ThreePointPlane3&) = default;
};

/// All x with normal . x <= offset: the normal points outward.
struct Halfspace2 {
  Vector2 normal;
  double offset;
  friend bool operator==(const Halfspace2&, const Halfspace2&) = default;
};
struct Halfspace3 {
  Vector3 normal;
  double offset;
  friend bool operator==(const Halfspace3&, const Halfspace3&) = default;
};

/// All x with min <= normal . x <= max; empty where min > max.
struct Slab2 {
  Vector2 normal;
  double min, max;
  friend bool operator==(const Slab2&, const Slab2&) = default;
};
struct Slab3 {
  Vector3 normal;
  double min, max;
  friend bool operator==(const Slab3&, const Slab3&) = default;
};

/// What lies in all of them.
struct HalfspaceIntersection2 {
  std::vector<Halfspace2> halfspaces;
  friend bool operator==(const HalfspaceIntersection2&, const HalfspaceIntersection2&) = default;
};
struct HalfspaceIntersection3 {
  std::vector<Halfspace3> halfspaces;
  friend bool operator==(const HalfspaceIntersection3&, const HalfspaceIntersection3&) = default;
};

template <class Take>
constexpr auto body(const Plane3& s, Take take) {
  return take("plane", part::normal("normal", s.normal), part::offset("offset", s.offset));
}
template <class Take>
constexpr auto body(const ThreePointPlane3& s, Take take) {
  return take("plane_of_points", part::place("a", s.a), part::place("b", s.b), part::place("c", s.c));
}
template <class Take>
constexpr auto body(const Halfspace2& s, Take take) {
  return take("halfspace", part::normal("normal", s.normal), part::offset("offset", s.offset));
}
template <class Take>
constexpr auto body(const Halfspace3& s, Take take) {
  return take("halfspace", part::normal("normal", s.normal), part::offset("offset", s.offset));
}
template <class Take>
constexpr auto body(const Slab2& s, Take take) {
  return take("slab", part::normal("normal", s.normal), part::offset("min", s.min), part::offset("max", s.max));
}
template <class Take>
constexpr auto body(const Slab3& s, Take take) {
  return take("slab", part::normal("normal", s.normal), part::offset("min", s.min), part::offset("max", s.max));
}
template <class Take>
constexpr auto body(const HalfspaceIntersection2& s, Take take) {
  return take("intersection", part::figure("halfspaces", s.halfspaces));
}
template <class Take>
constexpr auto body(const HalfspaceIntersection3& s, Take take) {
  return take("intersection", part::figure("halfspaces", s.halfspaces));
}

}  // namespace plumb
