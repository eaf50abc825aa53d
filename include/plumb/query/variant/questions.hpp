// What is asked about figures whose kinds are known at run time alone?  Every question of two figures, in any mix of
// AnyFigure and the kinds themselves, posed or not.
//
//   relate(any, sphere)  intersects  contains  distance  exact_distance  closest_points  compare_distance
//   first_hit(ray, any)  first_hit_parameter  hits
//   first_contact(Translating{any, {1, 0, 0}}, wall)  first_contact_time  intersects
//   first_contact(Moving{any, next}, Moving{other, other})  first_contact_time  intersects
//   intersection(any, any)            one of four results: AnyIntersection
//   locate(any, p)  support_point(any, direction)  support_value  fit_aabb
//   gjk, penetration and all that takes a ConvexBody3 (query/separation/convex_body.hpp) take one as well
//
// Laws: (1) those of the question; the answer and the error are those of the kinds, bit for bit.  (2) What a question has
// no answer for throws Unsupported, by name of both kinds, where the kinds themselves would not compile.  (3) An answer
// about figures of the plane is in the plane z = 0, as are points and directions that are asked of them; a motion or a
// point out of it throws Unsupported.
// Source: RTCD 2.3.
// Cost: that of the kinds and a jump for each figure; a few figures under poses and in motion are copied.  A program that
// asks all of these compiles as fast as one that asks one: the pairs are compiled in the library.  Nothing is
// searched but by that question.
#pragma once

#include <concepts>
#include <optional>
#include <variant>

#include "plumb/arith/root.hpp"
#include "plumb/figure/aabb/aabb.hpp"
#include "plumb/figure/containment/contains.hpp"
#include "plumb/figure/support/support.hpp"
#include "plumb/query/body/any_figure.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/ray/ray.hpp"
#include "plumb/query/section/planes.hpp"
#include "plumb/query/section/solid.hpp"
#include "plumb/query/time_of_impact/posed.hpp"
#include "plumb/query/time_of_impact/posed_corners.hpp"

namespace plumb {

using AnyIntersection = std::variant<Intersection2, Intersection3, SolidIntersection3, FlatIntersection>;

namespace query {

inline PosedView any_view(const AnyFigure& s) { return s.view(); }
template <PosedOrNot Shape>
PosedView any_view(const Shape& s) {
  return posed_view(s);
}

template <class S>
concept AnyOrKind = std::same_as<S, AnyFigure> || PosedOrNot<S>;
/// One of them at least is known at run time alone.
template <class A, class B>
concept AnyPair = (std::same_as<A, AnyFigure> || std::same_as<B, AnyFigure>)&&AnyOrKind<A>&& AnyOrKind<B>;

Relation any_relate(const PosedView& a, const PosedView& b);
bool any_intersects(const PosedView& a, const PosedView& b);
bool any_contains(const PosedView& outer, const PosedView& inner);

double any_distance(const PosedView& a, const PosedView& b, Question question);
ExactDistance any_exact_distance(const PosedView& a, const PosedView& b, Question question);
Closest any_closest_points(const PosedView& a, const PosedView& b);

std::optional<Hit> any_first_hit(const PosedView& ray, const PosedView& figure);
std::optional<RayParameter> any_first_hit_parameter(const PosedView& ray, const PosedView& figure);
bool any_hits(const PosedView& ray, const PosedView& figure);

AnyIntersection any_intersection(const PosedView& a, const PosedView& b);

Location any_locate(const AnyFigure& figure, const Point2& p);
Location any_locate(const AnyFigure& figure, const Point3& p);
Support3 any_support_point(const AnyFigure& figure, const Vector3& direction);
double any_support_value(const AnyFigure& figure, const Vector3& direction, Rounding rounding);
Aabb3 any_fit_aabb(const AnyFigure& figure);

std::optional<Contact> any_first_contact(const PosedMotion& a, const PosedMotion& b);
std::optional<Root> any_first_contact_time(const PosedMotion& a, const PosedMotion& b);
bool any_meet(const PosedMotion& a, const PosedMotion& b);

bool any_corners_meet(const CornersInMotion& a, const CornersInMotion& b, const ContactOptions& options);
std::optional<Contact> any_corner_contact(const CornersInMotion& a, const CornersInMotion& b,
                                          const ContactOptions& options);
std::optional<Root> any_corner_contact_time(const CornersInMotion& a, const CornersInMotion& b,
                                            const ContactOptions& options);

template <class S>
CornersInMotion any_corners(const Moving<S>& s) {
  return {any_view(s.from), any_view(s.to)};
}

template <class S>
PosedMotion any_motion(const Translating<S>& s) {
  if constexpr (requires { s.by.z; }) {
    return {any_view(s.shape), s.by};
  } else {
    return {any_view(s.shape), {s.by.x, s.by.y, 0}};
  }
}

}  // namespace query

template <class A, class B>
requires query::AnyPair<A, B> Relation relate(const A& a, const B& b) {
  return query::any_relate(query::any_view(a), query::any_view(b));
}
template <class A, class B>
requires query::AnyPair<A, B>
bool intersects(const A& a, const B& b) { return query::any_intersects(query::any_view(a), query::any_view(b)); }
template <class Outer, class Inner>
requires query::AnyPair<Outer, Inner>
bool contains(const Outer& outer, const Inner& inner) {
  return query::any_contains(query::any_view(outer), query::any_view(inner));
}
/// What it tells is told by locate of the kinds, which takes no poses; a constraint more than that, so that it is chosen.
template <class Shape>
requires LocatesPoints<Shape, Point2> && std::same_as<Shape, AnyFigure>
bool contains(const Shape& shape, const Point2& p) { return query::any_contains(shape.view(), query::any_view(p)); }
template <class Shape>
requires LocatesPoints<Shape, Point3> && std::same_as<Shape, AnyFigure>
bool contains(const Shape& shape, const Point3& p) { return query::any_contains(shape.view(), query::any_view(p)); }
template <class Shape>
requires LocatesPoints<Shape, Point2> && std::same_as<Shape, AnyFigure>
bool contains(const Shape& shape, const double (&p)[2]) { return contains(shape, Point2{p[0], p[1]}); }
template <class Shape>
requires LocatesPoints<Shape, Point3> && std::same_as<Shape, AnyFigure>
bool contains(const Shape& shape, const double (&p)[3]) { return contains(shape, Point3{p[0], p[1], p[2]}); }

namespace query {
/// For compare_distance, whose errors begin with its own name.
template <class A, class B>
requires AnyPair<A, B>
double distance_as(Question question, const A& a, const B& b) {
  return any_distance(any_view(a), any_view(b), question);
}
}  // namespace query

template <class A, class B>
requires query::AnyPair<A, B>
double distance(const A& a, const B& b) {
  return query::any_distance(query::any_view(a), query::any_view(b), query::Question::distance);
}
template <class A, class B>
requires query::AnyPair<A, B> ExactDistance exact_distance(const A& a, const B& b) {
  return query::any_exact_distance(query::any_view(a), query::any_view(b), query::Question::exact_distance);
}
/// Of two figures neither of which is round.
template <class A, class B>
requires query::AnyPair<A, B> Rational squared_distance_exact(const A& a, const B& b) {
  return query::any_exact_distance(query::any_view(a), query::any_view(b), query::Question::squared_distance_exact)
      .square;
}
template <class A, class B>
requires query::AnyPair<A, B> Closest closest_points(const A& a, const B& b) {
  return query::any_closest_points(query::any_view(a), query::any_view(b));
}

/// The first is a line, a ray or a segment.
template <class Ray, class Shape>
requires query::AnyPair<Ray, Shape> std::optional<Hit> first_hit(const Ray& ray, const Shape& shape) {
  return query::any_first_hit(query::any_view(ray), query::any_view(shape));
}
template <class Ray, class Shape>
requires query::AnyPair<Ray, Shape> std::optional<RayParameter> first_hit_parameter(const Ray& ray,
                                                                                    const Shape& shape) {
  return query::any_first_hit_parameter(query::any_view(ray), query::any_view(shape));
}
template <class Ray, class Shape>
requires query::AnyPair<Ray, Shape>
bool hits(const Ray& ray, const Shape& shape) { return query::any_hits(query::any_view(ray), query::any_view(shape)); }

template <class A, class B>
requires query::AnyPair<A, B> AnyIntersection intersection(const A& a, const B& b) {
  return query::any_intersection(query::any_view(a), query::any_view(b));
}

template <class A, class B>
requires query::AnyPair<A, B> std::optional<Contact> first_contact(const Translating<A>& a, const Translating<B>& b) {
  return query::any_first_contact(query::any_motion(a), query::any_motion(b));
}
template <class A, class B>
requires query::AnyPair<A, B> std::optional<Root> first_contact_time(const Translating<A>& a, const Translating<B>& b) {
  return query::any_first_contact_time(query::any_motion(a), query::any_motion(b));
}
template <class A, class B>
requires query::AnyPair<A, B>
bool intersects(const Translating<A>& a, const Translating<B>& b) {
  return query::any_meet(query::any_motion(a), query::any_motion(b));
}

/// Of points, segments and triangles; the two places of a figure are of one kind, each under a pose of its own.
template <class A, class B>
requires query::AnyPair<A, B> std::optional<Contact> first_contact(const Moving<A>& a, const Moving<B>& b,
                                                                   const ContactOptions& options = {}) {
  return query::any_corner_contact(query::any_corners(a), query::any_corners(b), options);
}
template <class A, class B>
requires query::AnyPair<A, B> std::optional<Root> first_contact_time(const Moving<A>& a, const Moving<B>& b,
                                                                     const ContactOptions& options = {}) {
  return query::any_corner_contact_time(query::any_corners(a), query::any_corners(b), options);
}
template <class A, class B>
requires query::AnyPair<A, B>
bool intersects(const Moving<A>& a, const Moving<B>& b, const ContactOptions& options = {}) {
  return query::any_corners_meet(query::any_corners(a), query::any_corners(b), options);
}

// Of one figure.  Templates, so that no kind becomes an AnyFigure on the way to a question that it has
// no answer for.
template <std::same_as<AnyFigure> Shape>
Location locate(const Shape& shape, const Point2& p) {
  return query::any_locate(shape, p);
}
template <std::same_as<AnyFigure> Shape>
Location locate(const Shape& shape, const Point3& p) {
  return query::any_locate(shape, p);
}
template <std::same_as<AnyFigure> Shape>
Support3 support_point(const Shape& shape, const Vector3& direction) {
  return query::any_support_point(shape, direction);
}
template <std::same_as<AnyFigure> Shape>
double support_value(const Shape& shape, const Vector3& direction, Rounding rounding = Rounding::up) {
  return query::any_support_value(shape, direction, rounding);
}
template <std::same_as<AnyFigure> Shape>
Aabb3 fit_aabb(const Shape& shape) {
  return query::any_fit_aabb(shape);
}

}  // namespace plumb
