// Circumscribed sphere: what is known exactly of the ball that some points span?  The smallest circle or sphere through
// one to four points.
//
// Laws: (1) the ball is the smallest with all its points on the boundary; its center lies in the points' affine hull.
// (2) Nothing of it is rounded: locate and compare_radius are exact, center and radius are rounded once.  (3) The order
// of the points changes nothing.  (4) Points that span no such ball (equal, collinear, coplanar: more of them than the
// dimension of their hull and one) throw InvalidShape; NaN and infinity throw NonFinite.
// Source: RTCD 4.3.5, 3.1.6.4.
// Cost: locate that of the signs in certify/smallest_sphere.hpp and insphere; center some 100 ns; compare_radius the
// same, and about 10 us where intervals leave doubt.  Nothing is searched.
#pragma once

#include <array>

#include "plumb/arith/point.hpp"
#include "plumb/arith/rounding.hpp"
#include "plumb/arith/sign.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

/// The first `count` of the points span it, 1 to 3.
struct SpannedCircle2 {
  std::array<Point2, 3> points;
  int count;
};
/// Likewise, 1 to 4.
struct SpannedSphere3 {
  std::array<Point3, 4> points;
  int count;
};

Location locate(const SpannedCircle2& ball, const Point2& p);
Location locate(const SpannedSphere3& ball, const Point3& p);

/// The exact center, every coordinate rounded to the nearest double; never -0.
Point2 center(const SpannedCircle2& ball);
Point3 center(const SpannedSphere3& ball);

/// The exact radius rounded as asked; infinite where that is beyond all doubles.
double radius(Rounding rounding, const SpannedCircle2& ball);
double radius(Rounding rounding, const SpannedSphere3& ball);

/// The exact radius of one against that of the other, or against a number.
Sign compare_radius(const SpannedCircle2& a, const SpannedCircle2& b);
Sign compare_radius(const SpannedSphere3& a, const SpannedSphere3& b);
Sign compare_radius(const SpannedCircle2& a, double radius);
Sign compare_radius(const SpannedSphere3& a, double radius);

}  // namespace plumb
