// Spheres, capsules, quadrics: what is round?  Balls, and sets of points near to something or below a curve: as given,
// nothing normalized.
//
// Laws: a shape is the closed set that its numbers say.  A radius or half extent of zero is a shape; a negative radius
// is none, and who is asked about it throws InvalidShape.  Of half extents the magnitude counts.
// Source: RTCD 4.3, 4.5, 4.7.
// Cost: none.
#pragma once

#include <array>

#include "plumb/figure/basic/body.hpp"
#include "plumb/figure/basic/plane.hpp"

namespace plumb {

struct Circle2 {  // the disk
  Point2 center;
  double radius;
  friend bool operator==(const Circle2&, const Circle2&) = default;
};
struct Sphere3 {  // the ball
  Point3 center;
  double radius;
  friend bool operator==(const Sphere3&, const Sphere3&) = default;
};

/// All points within `radius` of the segment ab: a swept sphere.
struct Capsule2 {
  Point2 a, b;
  double radius;
  friend bool operator==(const Capsule2&, const Capsule2&) = default;
};
struct Capsule3 {
  Point3 a, b;
  double radius;
  friend bool operator==(const Capsule3&, const Capsule3&) = default;
};

/// All points within `radius` of the parallelogram corner + s edges[0] + t edges[1], 0 <= s, t <= 1: a sphere-swept
/// rectangle, where the edges are perpendicular.
struct Lozenge3 {
  Point3 corner;
  std::array<Vector3, 2> edges;
  double radius;
  friend bool operator==(const Lozenge3&, const Lozenge3&) = default;
};

/// All points within `radius` of the line ab that lie between the planes through a and b perpendicular to it; for a = b
/// the ball, of which no direction is known to cut.
struct Cylinder3 {
  Point3 a, b;
  double radius;
  friend bool operator==(const Cylinder3&, const Cylinder3&) = default;
};

/// The convex hull of the apex and of the disk of this radius around `base`, perpendicular to the axis; for apex = base
/// the ball.
struct Cone3 {
  Point3 apex, base;
  double radius;
  friend bool operator==(const Cone3&, const Cone3&) = default;
};

/// All center + sum of t_i half_i axes_i with sum of t_i^2 <= 1, whatever the axes.
struct Ellipsoid3 {
  Point3 center;
  std::array<Vector3, 3> axes;
  Vector3 half;
  friend bool operator==(const Ellipsoid3&, const Ellipsoid3&) = default;
};

/// All of the ball that lies in the halfspace: for a plane beside the ball the whole of it or nothing, for one that
/// touches it the whole or a point; for a zero normal the ball or nothing.
struct SphericalCap3 {
  Sphere3 sphere;
  Halfspace3 halfspace;
  friend bool operator==(const SphericalCap3&, const SphericalCap3&) = default;
};

template <class Take>
constexpr auto body(const Circle2& s, Take take) {
  return take("circle", part::place("center", s.center), part::length("radius", s.radius));
}
template <class Take>
constexpr auto body(const Sphere3& s, Take take) {
  return take("sphere", part::place("center", s.center), part::length("radius", s.radius));
}
template <class Take>
constexpr auto body(const Capsule2& s, Take take) {
  return take("capsule", part::place("a", s.a), part::place("b", s.b), part::length("radius", s.radius));
}
template <class Take>
constexpr auto body(const Capsule3& s, Take take) {
  return take("capsule", part::place("a", s.a), part::place("b", s.b), part::length("radius", s.radius));
}
template <class Take>
constexpr auto body(const Lozenge3& s, Take take) {
  return take("lozenge", part::place("corner", s.corner), part::way("edges", s.edges),
              part::length("radius", s.radius));
}
template <class Take>
constexpr auto body(const Cylinder3& s, Take take) {
  return take("cylinder", part::place("a", s.a), part::place("b", s.b), part::length("radius", s.radius));
}
template <class Take>
constexpr auto body(const Cone3& s, Take take) {
  return take("cone", part::place("apex", s.apex), part::place("base", s.base), part::length("radius", s.radius));
}
template <class Take>
constexpr auto body(const Ellipsoid3& s, Take take) {
  return take("ellipsoid", part::place("center", s.center), part::axis("axes", s.axes), part::multiple("half", s.half));
}
template <class Take>
constexpr auto body(const SphericalCap3& s, Take take) {
  return take("cap", part::figure("sphere", s.sphere), part::figure("halfspace", s.halfspace));
}

}  // namespace plumb
