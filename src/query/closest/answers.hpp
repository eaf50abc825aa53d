// From a shape's features and feet to everything that is asked of it.  Instantiated where the shape is.
//
// For each shape there is a Nearest<Shape> with
//   static Feature feature(const Shape&, const Point&);                          which is nearest to p
//   template <class T> static Foot<T> foot(const Shape&, const Point&, const Feature&);
// and, where the shape is what is near to that, `static double radius(const Shape&)`, with which the feature says
// whether p is in it; where there may be nothing that is nearest, `static void require_some(function, const Shape&)`.
#pragma once

#include "figure/basic/in_space.hpp"
#include "plumb/query/closest/closest.hpp"
#include "query/body/figure_input.hpp"
#include "query/closest/numbers.hpp"
#include "query/closest/quick.hpp"

namespace plumb {

namespace query {

template <class Shape>
struct Nearest;

template <class Shape>
using PointOf = std::conditional_t<NearPoint2<Shape>, Point2, Point3>;

template <class Point>
constexpr Point within(const Point3& p) {
  if constexpr (std::is_same_v<Point, Point2>) {
    return {p.x, p.y};
  } else {
    return p;
  }
}

template <class Shape>
constexpr double radius_of(const Shape& shape) {
  if constexpr (requires { Nearest<Shape>::radius(shape); }) {
    return Nearest<Shape>::radius(shape);
  } else {
    return 0;
  }
}

template <class Shape>
NearestNumbers numbers_of(Wanted wanted, const Shape& shape, const PointOf<Shape>& p, const Feature& feature) {
  const auto exactly = [&] { return Nearest<Shape>::template foot<BigDyadic>(shape, p, feature); };
  return numbers(wanted, Nearest<Shape>::template foot<Ball>(shape, p, feature), in_space(p), radius_of(shape),
                 ExactFoot(exactly));
}

/// What convex_polyhedron proved is not looked at again.
template <class Shape>
void require(std::string_view function, const Shape& s, const PointOf<Shape>& p) {
  if constexpr (requires { s.mesh; }) {
    require_figure(function, "point", p);
  } else if (std::is_same_v<Shape, PointOf<Shape>> && function == "closest_point") {
    require_figures(function, s, p);  // which takes the shape first
  } else {
    require_figures(function, p, s);
  }
  if constexpr (requires { Nearest<Shape>::require_some(function, s); }) Nearest<Shape>::require_some(function, s);
}

/// By signs, pairs of doubles and integers: where there is no quick way, or it does not tell.
struct Answer {
  Feature feature;
  NearestNumbers numbers;  // those that are wanted
};
template <class Shape>
[[gnu::noinline]] Answer answer(std::string_view function, Wanted wanted, const Shape& shape, const PointOf<Shape>& p) {
  require(function, shape, p);
  const Feature feature = Nearest<Shape>::feature(shape, p);
  return {feature, numbers_of(wanted, shape, p, feature)};
}

template <class Shape, class To>
bool told_quickly(const Shape& shape, const PointOf<Shape>& p, To& to) {
  if constexpr (HasQuick<Shape>) {
    return quickly(shape, p, to);
  } else {
    return false;
  }
}

template <class Shape, class Result>
[[gnu::noinline, gnu::cold]] void answer_slowly(const Shape& shape, const PointOf<Shape>& p, Result& to) {
  const auto [feature, n] = answer("closest_points", Wanted::both, shape, p);
  to.on_b = within<PointOf<Shape>>(n.point), to.distance = n.distance, to.feature_b = feature;
}

template <class Shape, class Result>
Result closest_points_of(const PointOf<Shape>& p, const Shape& shape) {
  Result to;
  to.on_a = p;
  to.feature_a = {FeatureKind::vertex, 0};
  if (!told_quickly(shape, p, to)) answer_slowly(shape, p, to);
  return to;
}

template <class Shape>
PointOf<Shape> closest_point_of(const Shape& shape, const PointOf<Shape>& p) {
  PointOf<Shape> to;
  if (!told_quickly(shape, p, to))
    to = within<PointOf<Shape>>(answer("closest_point", Wanted::point, shape, p).numbers.point);
  return to;
}

template <class Shape>
double distance_of(const PointOf<Shape>& p, const Shape& shape, Question question) {
  double to;
  if (!told_quickly(shape, p, to)) to = answer(name_of(question), Wanted::distance, shape, p).numbers.distance;
  return to;
}

template <class Shape>
ExactDistance exact_distance_of(const PointOf<Shape>& p, const Shape& shape, Question question) {
  require(name_of(question), shape, p);
  const Feature feature = Nearest<Shape>::feature(shape, p);
  const Foot<BigDyadic> foot = Nearest<Shape>::template foot<BigDyadic>(shape, p, feature);
  return {rational_square(foot), foot.carrier == Carrier::itself ? Rational(0.0) : Rational(radius_of(shape))};
}

}  // namespace query

template <NearPoint2 Shape>
Closest2 closest_points(const Point2& p, const Shape& shape) {
  return query::closest_points_of<Shape, Closest2>(p, shape);
}
template <NearPoint3 Shape>
Closest closest_points(const Point3& p, const Shape& shape) {
  return query::closest_points_of<Shape, Closest>(p, shape);
}
template <NearPoint2 Shape>
Point2 closest_point(const Shape& shape, const Point2& p) {
  return query::closest_point_of(shape, p);
}
template <NearPoint3 Shape>
Point3 closest_point(const Shape& shape, const Point3& p) {
  return query::closest_point_of(shape, p);
}
template <NearPoint2 Shape>
double query::distance_as(Question question, const Point2& p, const Shape& shape) {
  return distance_of(p, shape, question);
}
template <NearPoint3 Shape>
double query::distance_as(Question question, const Point3& p, const Shape& shape) {
  return distance_of(p, shape, question);
}
template <FlatNearPoint2 Shape>
Rational squared_distance_exact(const Point2& p, const Shape& shape) {
  return query::exact_distance_of(p, shape, query::Question::squared_distance_exact).square;
}
template <FlatNearPoint3 Shape>
Rational squared_distance_exact(const Point3& p, const Shape& shape) {
  return query::exact_distance_of(p, shape, query::Question::squared_distance_exact).square;
}
template <NearPoint2 Shape>
ExactDistance exact_distance(const Point2& p, const Shape& shape) {
  return query::exact_distance_of(p, shape, query::Question::exact_distance);
}
template <NearPoint3 Shape>
ExactDistance exact_distance(const Point3& p, const Shape& shape) {
  return query::exact_distance_of(p, shape, query::Question::exact_distance);
}

// In the .cpp file of a shape, for each dimension: everything that is asked.
#define PLUMB_CLOSEST_ROUND(Answer, Point, Shape)                                            \
  template Answer closest_points(const Point& p, const Shape& shape);                        \
  template Point closest_point(const Shape& shape, const Point& p);                          \
  template double query::distance_as(Question question, const Point& p, const Shape& shape); \
  template ExactDistance exact_distance(const Point& p, const Shape& shape);
#define PLUMB_CLOSEST_FLAT(Answer, Point, Shape) \
  PLUMB_CLOSEST_ROUND(Answer, Point, Shape)      \
  template Rational squared_distance_exact(const Point& p, const Shape& shape);

}  // namespace plumb
