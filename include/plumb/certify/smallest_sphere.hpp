// Minimum enclosing ball: does a point lie inside the smallest circle or sphere through some points?
//
// Laws: (1) positive inside, zero on it, negative outside, whatever the order of the points that span it.  (2) Equal
// ones among these count once: the smallest sphere through one point is that point.  (3) Zero for every point where
// there is no such circle or sphere: three collinear points that differ.
// A coordinate that is NaN or infinite throws NonFinite, naming it.
// Source: RTCD 4.3, 3.1.6.3, 3.1.6.4.
// Cost: a call and the filter (docs/predicates.md), two of them for the circle through three points.
#pragma once

#include "plumb/arith/point.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

/// The circle (sphere) that has the segment ab as its diameter.
Sign in_smallest_circle(const Point2& a, const Point2& b, const Point2& p);
Sign in_smallest_sphere(const Point3& a, const Point3& b, const Point3& p);

/// The circle through three points: incircle without regard to their turn.
Sign in_smallest_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& p);

/// The sphere through three points that has its center in their plane.
Sign in_smallest_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& p);

}  // namespace plumb
