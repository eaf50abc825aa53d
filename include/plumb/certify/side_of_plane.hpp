// Plane test: on which side of a plane (line) given by normal and offset does a point lie, and how far from it?
//
// The plane is the set of x with normal . x = offset, as the numbers say: the normal need not have length one.
// Laws: (1) negating normal and offset flips the side and keeps the distance.  (2) Multiplying both by the same
// positive number, where nothing is rounded, changes nothing.  (3) With a zero normal the set is everything (offset
// zero), or nothing: the distance is then zero, or above every number, and the side that of minus the offset.
// A coordinate that is NaN or infinite throws NonFinite: a is the normal, b the offset, c the point, d the distance.
// Source: RTCD 3.6, 5.1.1.
// Cost: a call and the filter (docs/predicates.md); degenerate input is left to the last stage, for the terms differ in
// degree.
#pragma once

#include "plumb/arith/point.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

/// Positive on the side to which the normal points, zero on the line (plane).
Sign side_of_line(const Vector2& normal, double offset, const Point2& p);
Sign side_of_plane(const Vector3& normal, double offset, const Point3& p);

/// The distance of p from the line (plane) against a number, which may be negative and is then below every distance.
Sign compare_distance_to_line(const Vector2& normal, double offset, const Point2& p, double distance);
Sign compare_distance_to_plane(const Vector3& normal, double offset, const Point3& p, double distance);

}  // namespace plumb
