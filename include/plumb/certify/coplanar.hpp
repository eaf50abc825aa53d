// How do points of a plane in space lie to one another?  Orientation without a projection chosen by hand.
//
// Laws: (1) swapping two of a, b, c flips the sign.  (2) Zero exactly when a, b, c are collinear, or when the eye is in
// their plane or the direction parallel to it.  (3) All triples of points of one plane are told their orientation from
// the same side.  (4) For points of one plane coplanar_orientation(a, b, c, d) is the product of
// coplanar_orientation(a, b, c) and coplanar_orientation(a, b, d).
// A coordinate that is NaN or infinite throws NonFinite.
// Source: RTCD 3.1.6.1, 3.3.7; CGAL's manual for coplanar_orientation.
// Cost: one sign of degree 3 or 4, up to three of degree 2 for three points.
#pragma once

#include "plumb/arith/point.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/predicates/cross_products.hpp"
#include "plumb/predicates/line_triangle.hpp"

namespace plumb {

/// Positive when a, b, c turn counterclockwise for an eye that is infinitely far away in this direction.  Also: does
/// the direction point away from the plane on the side of the normal (b - a) x (c - a)?
template <int = 0>
inline Sign orient_seen_from(const Vector3& direction, const Point3& a, const Point3& b, const Point3& c) {
  return decide<predicates::OrientSeenFrom>({direction.x, direction.y, direction.z,  //
                                             a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z});
}

/// Positive when a, b, c turn counterclockwise for this eye: when it is above their plane.
template <int = 0>
inline Sign orient_seen_from(const Point3& eye, const Point3& a, const Point3& b, const Point3& c) {
  return -decide<predicates::Orient3d>({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, eye.x, eye.y, eye.z});
}

/// Positive when a, b, c turn counterclockwise as seen from the side of their plane that is fixed by the plane alone:
/// from above (+z) unless the plane is vertical, otherwise from the right (+x), otherwise, for a plane of constant y,
/// from the front (-y).  Equal to CGAL's choice.
template <int = 0>
inline Sign coplanar_orientation(const Point3& a, const Point3& b, const Point3& c) {
  if ((a.z - a.z) + (b.z - b.z) + (c.z - c.z) != 0) {  // NaN: the look from above is blind to it
    throw_non_finite("coplanar_orientation", std::array{3, 3, 3},
                     std::array{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z});
  }
  using predicates::Orient2d;
  if (const Sign s = decide<Orient2d>({a.x, a.y, b.x, b.y, c.x, c.y}); s != Sign::zero) return s;
  if (const Sign s = decide<Orient2d>({a.y, a.z, b.y, b.z, c.y, c.z}); s != Sign::zero) return s;
  return decide<Orient2d>({a.x, a.z, b.x, b.z, c.x, c.z});
}

/// For points of one plane: positive when c and d lie on the same side of the line ab, negative on opposite sides, zero
/// when d, or c, is on it.  For others: whether the half planes from ab through c and through d enclose an acute, right
/// (zero) or obtuse angle.
template <int = 0>
inline Sign coplanar_orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return decide<predicates::CoplanarSide>({a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z});
}

}  // namespace plumb
