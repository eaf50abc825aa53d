// Which of two points comes first, and how do two directions lie to one another?  Orders, angles, parallels.
//
// Laws: (1) compare_*(a, b) is the sign of a's place minus b's; swapping a and b flips it.  (2) A dot product's sign is
// kept when its factors are swapped, a cross product's is flipped; negating a factor flips both.  (3) parallel and
// collinear are true exactly when every coordinate of the cross product is exactly zero: a zero vector is parallel and
// perpendicular to all, and two equal points are collinear with any third.
// A coordinate that is NaN or infinite throws NonFinite, naming it.
// Source: RTCD 3.3.3, 3.3.5.
// Cost: a call and the filter (docs/predicates.md); decide<formula> inlines the filter.
#pragma once

#include "plumb/arith/point.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

/// Order along an axis: of a.x and b.x.
Sign compare_x(const Point2& a, const Point2& b);
Sign compare_y(const Point2& a, const Point2& b);
Sign compare_x(const Point3& a, const Point3& b);
Sign compare_y(const Point3& a, const Point3& b);
Sign compare_z(const Point3& a, const Point3& b);

/// By x, where these are equal by y, then by z: zero for equal points alone.
Sign compare_lexicographically(const Point2& a, const Point2& b);
Sign compare_lexicographically(const Point3& a, const Point3& b);

/// Order along a direction, of the points projected onto it; zero for all when the direction is.
Sign compare_along_direction(const Point2& a, const Point2& b, const Vector2& direction);
Sign compare_along_direction(const Point3& a, const Point3& b, const Vector3& direction);

/// Order along the line from c to d, of the points projected onto it; zero for all when c and d are equal.
Sign compare_along_line(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
Sign compare_along_line(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// Does b lie on the segment from a to c, its ends included?
bool are_ordered_along_line(const Point2& a, const Point2& b, const Point2& c);
bool are_ordered_along_line(const Point3& a, const Point3& b, const Point3& c);

/// Positive for an acute angle between the vectors, zero for a right one, negative for an obtuse one.
Sign dot_sign(const Vector2& a, const Vector2& b);
Sign dot_sign(const Vector3& a, const Vector3& b);

/// The same of the angle at b, between the directions to a and to c.
Sign angle_sign(const Point2& a, const Point2& b, const Point2& c);
Sign angle_sign(const Point3& a, const Point3& b, const Point3& c);

/// Positive when b points to the left of a.
Sign cross_sign(const Vector2& a, const Vector2& b);

bool perpendicular(const Vector2& a, const Vector2& b);
bool perpendicular(const Vector3& a, const Vector3& b);

/// In the same or the opposite direction.
bool parallel(const Vector2& a, const Vector2& b);
bool parallel(const Vector3& a, const Vector3& b);

/// Do the points lie on one line?
bool collinear(const Point2& a, const Point2& b, const Point2& c);
bool collinear(const Point3& a, const Point3& b, const Point3& c);

}  // namespace plumb
