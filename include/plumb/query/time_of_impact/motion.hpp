// Swept test: what moves, how, and when does it meet?  Figures in motion during time [0, 1].
//
// Laws: a moving figure is what its shapes say at every time; nothing is rounded on the way.  One that does not move is
// one whose motion is zero.
// Source: RTCD 2.4.3, 5.5.
// Cost: none.
#pragma once

#include <concepts>
#include <optional>

#include "plumb/arith/point.hpp"
#include "plumb/arith/pose.hpp"
#include "plumb/arith/rigid_pose.hpp"
#include "plumb/arith/root.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"

namespace plumb {

struct Segment2;
struct Triangle2;
struct Aabb2;
struct Obb2;
struct Circle2;
struct Capsule2;
struct Polygon2;
struct HoledPolygon2;

/// What moves in the plane.
template <class Shape>
concept MovesInPlane = std::same_as<Shape, Point2> || std::same_as<Shape, Segment2> || std::same_as<Shape, Triangle2> ||
    std::same_as<Shape, Aabb2> || std::same_as<Shape, Obb2> || std::same_as<Shape, Circle2> ||
    std::same_as<Shape, Capsule2> || std::same_as<Shape, Polygon2> || std::same_as<Shape, HoledPolygon2>;

/// Moves by `by` during time [0, 1].
template <class Shape>
struct Translating {
  Shape shape;
  Vector3 by;
  friend bool operator==(const Translating&, const Translating&) = default;
};
template <MovesInPlane Shape>
struct Translating<Shape> {
  Shape shape;
  Vector2 by;
  friend bool operator==(const Translating&, const Translating&) = default;
};
/// A figure of the plane under a pose of the plane.
template <class Shape, class By>
requires PoseOfPlane<By>
struct Translating<Posed<Shape, By>> {
  Posed<Shape, By> shape;
  Vector2 by;
  friend bool operator==(const Translating&, const Translating&) = default;
};
template <class Shape>
Translating(Shape, Vector3) -> Translating<Shape>;
template <class Shape>
Translating(Shape, Vector2) -> Translating<Shape>;

/// Every vertex moves linearly during time [0, 1].
template <class Shape>
struct Moving {
  Shape from, to;
  friend bool operator==(const Moving&, const Moving&) = default;
};
template <class Shape>
Moving(Shape, Shape) -> Moving<Shape>;

/// The first time at which two figures meet, rounded down: never late, and within 1 ulp; and the features that meet
/// then, those of the lowest dimension first, then those of the lowest number (figure/containment/voronoi_region.hpp).
struct Contact {
  double time;
  Feature feature_a, feature_b;
  friend bool operator==(const Contact&, const Contact&) = default;
};

/// The same answer with the figures named the other way round.
constexpr Contact swapped(const Contact& c) { return {c.time, c.feature_b, c.feature_a}; }

namespace query {

template <class S>
inline constexpr bool is_translating = false;
template <class S>
inline constexpr bool is_translating<Translating<S>> = true;
/// Two figures that first_contact takes in motion, given without their motions.
template <class A, class B>
concept MeetInMotion =
    !is_translating<A> && !is_translating<B> && requires(const Translating<A>& a, const Translating<B>& b) {
  first_contact(a, b);
};

}  // namespace query

/// One of two figures in motion stands still, and is given as it is.
template <class A, class B>
requires query::MeetInMotion<A, B> std::optional<Contact> first_contact(const Translating<A>& a, const B& b) {
  return first_contact(a, Translating<B>{b, {}});
}
template <class A, class B>
requires query::MeetInMotion<A, B> std::optional<Contact> first_contact(const A& a, const Translating<B>& b) {
  return first_contact(Translating<A>{a, {}}, b);
}
template <class A, class B>
requires query::MeetInMotion<A, B> std::optional<Root> first_contact_time(const Translating<A>& a, const B& b) {
  return first_contact_time(a, Translating<B>{b, {}});
}
template <class A, class B>
requires query::MeetInMotion<A, B> std::optional<Root> first_contact_time(const A& a, const Translating<B>& b) {
  return first_contact_time(Translating<A>{a, {}}, b);
}
template <class A, class B>
requires query::MeetInMotion<A, B>
bool intersects(const Translating<A>& a, const B& b) { return intersects(a, Translating<B>{b, {}}); }
template <class A, class B>
requires query::MeetInMotion<A, B>
bool intersects(const A& a, const Translating<B>& b) { return intersects(Translating<A>{a, {}}, b); }

}  // namespace plumb
