// Closest points and distance: which points of two figures are nearest to one another, and how far apart are they?
//
//   closest_points(p, triangle)      both points, their features and the distance
//   closest_point(triangle, p)       the point of the shape
//   distance(p, triangle)            the number; squared_distance_exact and exact_distance without any rounding
//   compare_distance(p, triangle, q, sphere)   which is the larger, exactly
//
// Here a point against any shape; lines, segments and triangles against one another in query/closest/pairs.hpp.
// Laws: (1) those of query/closest/result.hpp: features exact, numbers rounded once.  (2) Shapes are closed sets,
// degenerate ones as well: a line of zero direction is its point (vertex 0), a triangle may be a segment, a plane of
// three points a line, a box flat.  (3) Naming the figures the other way round swaps the answer.  (4) Of several
// nearest points of a polygon that of the feature of lowest dimension, then of lowest number.  (5) compare_distance
// is the sign of real arithmetic for all distances that can be asked for.
// Features, beyond those of voronoi_region: a polygon's vertices and edges count through its chains in turn, the
// outer one first, an edge by the vertex that it leaves; a rectangle's, and a box's in the plane, are numbered as a
// box's, an edge 2 times its axis, plus 1 at the upper end of the other; a capsule's side is face 0, its ends about
// a and b are faces 1 and 2; a lozenge's plates are face 0, what is about the edges and corners of its core, numbered
// as a rectangle's, faces 1 to 4 and 5 to 8.
// In the plane the inside is face 0, the boundary of a disk edge 0, those of a capsule edges 0 to 2.
// An empty box or plane, a negative radius and a polygon in space that is not planar throw InvalidShape; NaN and
// infinity throw NonFinite, naming the part.
// Source: RTCD 5.1.1, 5.1.2, 5.1.2.1, 5.1.3, 5.1.3.1, 5.1.4, 5.1.4.1, 5.1.4.2, 5.1.5, 5.1.6, 5.1.7 (figures 5.1 to
// 5.6).
// Cost: docs/closest.md.  Bounded by n^2 pairs of features for n corners of both, on integers as long as the exponents'
// span.
#pragma once

#include <array>
#include <concepts>

#include "plumb/arith/error.hpp"
#include "plumb/arith/exact_distance.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/query/body/answered.hpp"
#include "plumb/query/body/detail/question.hpp"
#include "plumb/query/closest/pairs.hpp"
#include "plumb/query/closest/result.hpp"

namespace plumb {

namespace query {

template <class Shape, class... Shapes>
concept AnyOf = (std::same_as<Shape, Shapes> || ...);

}  // namespace query

/// Shapes whose nearest point to a point has rational coordinates.
template <class Shape>
concept FlatNearPoint2 = query::AnyOf<Shape, Point2, Line2, Ray2, Segment2, Halfspace2, Triangle2, Quadrilateral2,
                                      Polygon2, HoledPolygon2, Aabb2, Obb2>;
template <class Shape>
concept FlatNearPoint3 =
    query::AnyOf<Shape, Point3, Line3, Ray3, Segment3, Plane3, ThreePointPlane3, Halfspace3, Triangle3, Quadrilateral3,
                 Polygon3, HoledPolygon3, Rectangle3, Tetrahedron3, Aabb3, Obb3, ConvexPolyhedron3>;
/// Those and the round ones: all that a point's nearest point is asked of.
template <class Shape>
concept NearPoint2 = FlatNearPoint2<Shape> || query::AnyOf<Shape, Circle2, Capsule2>;
template <class Shape>
concept NearPoint3 = FlatNearPoint3<Shape> || query::AnyOf<Shape, Sphere3, Capsule3, Lozenge3>;

namespace query {

/// By whose name errors begin.
template <NearPoint2 Shape>
double distance_as(Question question, const Point2& p, const Shape& shape);
template <NearPoint3 Shape>
double distance_as(Question question, const Point3& p, const Shape& shape);

}  // namespace query

template <NearPoint2 Shape>
Closest2 closest_points(const Point2& p, const Shape& shape);
template <NearPoint3 Shape>
Closest closest_points(const Point3& p, const Shape& shape);

/// The nearest double to each coordinate of the shape's point that is nearest to p.
template <NearPoint2 Shape>
Point2 closest_point(const Shape& shape, const Point2& p);
template <NearPoint3 Shape>
Point3 closest_point(const Shape& shape, const Point3& p);

template <NearPoint2 Shape>
double distance(const Point2& p, const Shape& shape) {
  return query::distance_as(query::Question::distance, p, shape);
}
template <NearPoint3 Shape>
double distance(const Point3& p, const Shape& shape) {
  return query::distance_as(query::Question::distance, p, shape);
}

template <FlatNearPoint2 Shape>
Rational squared_distance_exact(const Point2& p, const Shape& shape);
template <FlatNearPoint3 Shape>
Rational squared_distance_exact(const Point3& p, const Shape& shape);

template <NearPoint2 Shape>
ExactDistance exact_distance(const Point2& p, const Shape& shape);
template <NearPoint3 Shape>
ExactDistance exact_distance(const Point3& p, const Shape& shape);

/// Where along it the nearest point is: point + t direction, a + t (b - a).  Rounded once.
double closest_parameter(const Line2& line, const Point2& p);
double closest_parameter(const Line3& line, const Point3& p);
double closest_parameter(const Ray2& ray, const Point2& p);
double closest_parameter(const Ray3& ray, const Point3& p);
double closest_parameter(const Segment2& segment, const Point2& p);
double closest_parameter(const Segment3& segment, const Point3& p);

/// The barycentric coordinates of the nearest point: zero at the corners that its feature does not have.
std::array<double, 3> closest_weights(const Triangle2& triangle, const Point2& p);
std::array<double, 3> closest_weights(const Triangle3& triangle, const Point3& p);

// What is asked for is named in the requirement, not in the result: Clang 14 looks at a result's type first.
template <class A, class B>
requires(OtherWayRound<A, B>&& requires(const A& a, const B& b) { closest_points(b, a); })  //
    auto closest_points(const A& a, const B& b) {
  return swapped(closest_points(b, a));
}
template <class A, class B>
requires(OtherWayRound<A, B>&& requires(const A& a, const B& b) { distance(b, a); })  //
    double distance(const A& a, const B& b) {
  return distance(b, a);
}
template <class A, class B>
requires(OtherWayRound<A, B>&& requires(const A& a, const B& b) { squared_distance_exact(b, a); })  //
    Rational squared_distance_exact(const A& a, const B& b) {
  return squared_distance_exact(b, a);
}
template <class A, class B>
requires(OtherWayRound<A, B>&& requires(const A& a, const B& b) { exact_distance(b, a); })  //
    ExactDistance exact_distance(const A& a, const B& b) {
  return exact_distance(b, a);
}

/// Of two straight ones.
template <class A, class B>
requires query::StraightPair<A, B> ExactDistance exact_distance(const A& a, const B& b) {
  return {query::squared_distance_as(query::Question::exact_distance, a, b)};
}

/// What distance and exact_distance answer for.
template <class A, class B>
concept HasDistance = requires(const A& a, const B& b) {
  { distance(a, b) } -> std::same_as<double>;
  { exact_distance(a, b) } -> std::same_as<ExactDistance>;
};

namespace query {

/// In the order of the table.
template <class A, class B>
requires HasDistance<A, B>
double distance_in_order(Question question, const A& a, const B& b) {
  if constexpr (OtherWayRound<A, B>) {
    return distance_as(question, b, a);
  } else {
    return distance_as(question, a, b);
  }
}

}  // namespace query

/// |ab| against |cd|.  Rounding keeps order, so that doubles that differ tell.
template <class A, class B, class C, class D>
requires(HasDistance<A, B>&& HasDistance<C, D>) Sign compare_distance(const A& a, const B& b, const C& c, const D& d) {
  using query::Question, query::distance_in_order;
  const double first = distance_in_order(Question::compare_distance, a, b);
  const double second = distance_in_order(Question::compare_second_distance, c, d);
  if (first != second) return first < second ? Sign::negative : Sign::positive;
  return compare(exact_distance(a, b), exact_distance(c, d));
}

/// |ab| against a number.
template <class A, class B>
requires HasDistance<A, B> Sign compare_distance(const A& a, const B& b, double than) {
  if (!(than - than == 0)) throw NonFinite("compare_distance: the distance is not a real number; give a finite one");
  if constexpr (query::StraightPair<A, B>) {
    if (const auto quick = query::quick_comparison(a, b, than)) return *quick;
  }
  const double first = query::distance_in_order(query::Question::compare_distance, a, b);
  if (first != than) return first < than ? Sign::negative : Sign::positive;
  return compare(exact_distance(a, b), than);
}

}  // namespace plumb
