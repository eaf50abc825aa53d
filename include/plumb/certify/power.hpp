// Power diagram: which weighted point governs a place?  The tests of regular triangulations and power diagrams.
//
// The power of x from a weighted point (c, w) is |cx|^2 - w.  With a squared radius as weight, a weighted point is a
// circle or sphere, and the power of x is negative inside; a weight may also be negative.
// Laws: (1) with equal weights in_power_circle, in_power_sphere and compare_power are incircle, insphere and
// compare_distance.  (2) Adding one number to all weights, where nothing is rounded, changes none of these three.
// A coordinate or weight that is NaN or infinite throws NonFinite, naming it: "power_circle: b.w is nan".
// Source: RTCD 3.1.6.3, 3.1.6.4; Aurenhammer 1987, power diagrams.
// Cost: a call and the filter (docs/predicates.md); degenerate input is left to the last stage, for the terms differ in
// degree.
#pragma once

#include "plumb/arith/point.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

struct WeightedPoint2 {
  Point2 point;
  double weight;
  friend bool operator==(const WeightedPoint2&, const WeightedPoint2&) = default;
};

struct WeightedPoint3 {
  Point3 point;
  double weight;
  friend bool operator==(const WeightedPoint3&, const WeightedPoint3&) = default;
};

/// For counterclockwise a, b, c: positive when d is nearer to the circle orthogonal to all three, by its power, than
/// its weight allows, so that the triangle abc cannot be in a regular triangulation with d; zero when one circle is
/// orthogonal to all four.
Sign in_power_circle(const WeightedPoint2& a, const WeightedPoint2& b, const WeightedPoint2& c,
                     const WeightedPoint2& d);

/// The same of a sphere, for orient3d(a, b, c, d) > 0.
Sign in_power_sphere(const WeightedPoint3& a, const WeightedPoint3& b, const WeightedPoint3& c, const WeightedPoint3& d,
                     const WeightedPoint3& e);

/// The power of p from a against its power from b.
Sign compare_power(const Point2& p, const WeightedPoint2& a, const WeightedPoint2& b);
Sign compare_power(const Point3& p, const WeightedPoint3& a, const WeightedPoint3& b);

/// The sign of p's power from a: negative inside the circle or sphere, zero on it.
Sign power_sign(const Point2& p, const WeightedPoint2& a);
Sign power_sign(const Point3& p, const WeightedPoint3& a);

/// |ab|^2 against the sum of both weights: zero when the two circles or spheres are orthogonal.
Sign power_sign(const WeightedPoint2& a, const WeightedPoint2& b);
Sign power_sign(const WeightedPoint3& a, const WeightedPoint3& b);

}  // namespace plumb
