// What is the difference of two points, and the like, in doubles?  By name, and each coordinate rounded once.
//
//   Vector3 v = rounded_difference(b, a);        // not b - a: it is not, where bits are lost
//   double  d = rounded_dot(v, w);               // of v and w as they are now, whatever was lost before
//
// There are no operators, because what they would make is not exact, and a sign of it may be wrong: a decision about
// points takes the points (orient3d, angle_sign, compare_distance, sign_of), not what was made of them.  They are
// deleted, so that who writes one is told these names; one of your own is taken as ever.
// exact_difference and exact_sum give the vector or point only where doubles hold it; negated is always exact.
// Laws: (1) each coordinate and number is the exact one of the arguments, rounded once to the nearest double, ties to
// even; zero is never -0, but in what negated makes; infinite beyond all doubles.  (2) rounded_difference(a, b) and
// (b, a) are each other's negative, a midpoint does not depend on the order.  (3) rounded_lerp is a for t = 0 and b for
// t = 1, for other t between them or beyond, as t is.
// NaN and infinity throw NonFinite, by name.
// Source: RTCD 3.2, 3.3, 3.3.3, 3.3.5, 3.3.7.
// Cost: that of the plain operation for sums, differences and midpoints; some 20 ns a number for the others
// (certify/rounded.hpp).  Nothing is searched.
#pragma once

#include <concepts>
#include <optional>

#include "plumb/arith/no_answer.hpp"
#include "plumb/arith/point.hpp"

namespace plumb {

/// a - b.
Vector2 rounded_difference(const Point2& a, const Point2& b);
Vector3 rounded_difference(const Point3& a, const Point3& b);
Vector2 rounded_difference(const Vector2& a, const Vector2& b);
Vector3 rounded_difference(const Vector3& a, const Vector3& b);

/// a + v.
Point2 rounded_sum(const Point2& a, const Vector2& v);
Point3 rounded_sum(const Point3& a, const Vector3& v);
Vector2 rounded_sum(const Vector2& a, const Vector2& v);
Vector3 rounded_sum(const Vector3& a, const Vector3& v);

/// Nothing where a coordinate would have to be rounded.
std::optional<Vector2> exact_difference(const Point2& a, const Point2& b);
std::optional<Vector3> exact_difference(const Point3& a, const Point3& b);
std::optional<Point2> exact_sum(const Point2& a, const Vector2& v);
std::optional<Point3> exact_sum(const Point3& a, const Vector3& v);

constexpr Vector2 negated(const Vector2& v) { return {-v.x, -v.y}; }
constexpr Vector3 negated(const Vector3& v) { return {-v.x, -v.y, -v.z}; }

/// (a + b) / 2.
Point2 rounded_midpoint(const Point2& a, const Point2& b);
Point3 rounded_midpoint(const Point3& a, const Point3& b);

/// a + t (b - a).  The unrounded point, which predicates take: SegmentPoint3 (certify/implicit.hpp).
Point2 rounded_lerp(const Point2& a, const Point2& b, double t);
Point3 rounded_lerp(const Point3& a, const Point3& b, double t);

/// t v.
Vector2 rounded_multiple(double t, const Vector2& v);
Vector3 rounded_multiple(double t, const Vector3& v);

double rounded_dot(const Vector2& u, const Vector2& v);
double rounded_dot(const Vector3& u, const Vector3& v);
/// u.x v.y - u.y v.x.
double rounded_cross(const Vector2& u, const Vector2& v);
Vector3 rounded_cross(const Vector3& u, const Vector3& v);
/// u . (v x w), the determinant of the three: by how much a matrix of these columns enlarges volumes.
double rounded_triple(const Vector3& u, const Vector3& v, const Vector3& w);
double rounded_length(const Vector2& v);
double rounded_length(const Vector3& v);

/// (b - a) x (c - a), from the points themselves.
Vector3 rounded_normal(const Point3& a, const Point3& b, const Point3& c);

namespace figure {
/// A point or a vector.  No template takes the operators' arguments, of which Clang would say all twice.
struct Coordinates {
  template <class T>
  requires(std::same_as<T, Point2> || std::same_as<T, Point3> || std::same_as<T, Vector2> ||
           std::same_as<T, Vector3>)  //
      Coordinates(const T&);          // NOLINT: stands for any of them
};
}  // namespace figure

PLUMB_NO_ANSWER_TYPE(bool, "plumb: no operator == of a point and a vector, or of the plane and of space")
operator==(const figure::Coordinates&, const figure::Coordinates&) PLUMB_DELETED;
PLUMB_NO_ANSWER_TYPE(
    Vector3,
    "plumb: no operator - of points and vectors: rounded_difference(a, b) rounds each coordinate once, "
    "exact_difference(a, b) never; decisions take the points themselves (orient3d, compare_distance)")
operator-(const figure::Coordinates&, const figure::Coordinates&) PLUMB_DELETED;
PLUMB_NO_ANSWER_TYPE(Vector3,
                     "plumb: no operator + of points and vectors: rounded_sum(p, v) rounds each coordinate once, "
                     "exact_sum(p, v) never; decisions take the points themselves (orient3d, compare_distance)")
operator+(const figure::Coordinates&, const figure::Coordinates&) PLUMB_DELETED;
PLUMB_NO_ANSWER_TYPE(Vector3, "plumb: no operator - of a vector: negated(v)")
operator-(const figure::Coordinates&) PLUMB_DELETED;
PLUMB_NO_ANSWER_TYPE(Vector3, "plumb: no operator * of a vector and a number: rounded_multiple(t, v)")
operator*(const figure::Coordinates&, double) PLUMB_DELETED;
PLUMB_NO_ANSWER_TYPE(Vector3, "plumb: no operator * of a number and a vector: rounded_multiple(t, v)")
operator*(double, const figure::Coordinates&) PLUMB_DELETED;
PLUMB_NO_ANSWER_TYPE(double, "plumb: no operator * of two vectors: rounded_dot(v, w) or rounded_cross(v, w)")
operator*(const figure::Coordinates&, const figure::Coordinates&) PLUMB_DELETED;
PLUMB_NO_ANSWER_TYPE(Vector3, "plumb: no operator / of a vector and a number: rounded_multiple(1 / t, v)")
operator/(const figure::Coordinates&, double) PLUMB_DELETED;

}  // namespace plumb
