// What is asked of a figure of your own that is a rounded hull (query/body/rounded_hull.hpp)?  Every question of two
// figures, together with the kinds, AnyFigure and others of your own.
//
//   relate(cushion, box)  intersects  contains  distance  exact_distance  compare_distance  closest_points
//   first_hit(ray, cushion)  hits  first_contact(Translating{cushion, {1, 0, 0}}, wall)  support_point  fit_aabb
//   gjk, penetration and all else that takes a ConvexBody3
//
// Laws: (1) the set is all points at most the radius away from the convex hull of the places, in real arithmetic; answers
// are exact, then rounded once, as those of the kinds are.  It may stand under a pose, as they do.  (2) Where hull and
// radius are a figure of a kind (no radius: a point, a segment, a convex polygon or polyhedron; of one or two places a
// ball or a capsule) all is that figure's.  (3) Else relate, intersects and distances are told by the distance of the
// hulls; closest_points of convex bodies, by GJK; contains of what is convex; first_contact, whose
// features are those of the hull, takes what first_contact takes but polygons; first_hit and intersection
// throw Unsupported, a pose that is a matrix UnevenPose.
// NaN and infinity throw NonFinite, a negative radius and no place InvalidShape, by name.
// Source: RTCD 4.5, 11.3.4.
// Cost: the hull of the places, some microseconds, beside that of the question.  Nothing is searched but by the hull
// and by that question.
#pragma once

#include "plumb/query/gjk/gjk.hpp"
#include "plumb/query/variant/questions.hpp"

namespace plumb {

namespace query {

/// All within the radius of the figure; a radius of zero where the figure says it all.
struct RoundedFigure {
  AnyFigure figure;
  double radius = 0;
};
RoundedFigure rounded_figure(const PlacesAndRadius& of);
/// A radius that is left keeps a rigid pose alone: UnevenPose.
RoundedFigure posed_figure(std::string_view function, const RoundedFigure& s, const AnyPose& pose);

/// What a question looks at: the hull of a figure of your own, and of any other itself.
struct RoundedView {
  PosedView figure;
  double radius;
};
inline RoundedView rounded_view(const RoundedFigure& s) { return {s.figure.view(), s.radius}; }
template <AnyOrKind Shape>
RoundedView rounded_view(const Shape& s) {
  return {any_view(s), 0};
}

template <RoundedHullFigure Shape>
RoundedFigure seen(std::string_view function, const Shape& s) {
  figure::require_sound(function, s);
  return rounded_figure(places_and_radius(s));
}
template <RoundedHullFigure Shape, PoseOfSpace By>
RoundedFigure seen(std::string_view function, const Posed<Shape, By>& s) {
  return posed_figure(function, seen(function, s.shape), s.pose);
}
template <AnyOrKind Shape>
const Shape& seen(std::string_view, const Shape& s) {
  return s;
}

/// Your own, as it stands or under a pose.
template <class S>
concept OwnBody3 = RoundedHullFigure<UnposedType<S>> && ConvexBody3<S>;
template <class S>
concept OwnOrKind = OwnBody3<S> || AnyOrKind<S>;
/// One of them at least is your own.
template <class A, class B>
concept OwnPair = (OwnBody3<A> || OwnBody3<B>)&&OwnOrKind<A>&& OwnOrKind<B>;

Relation rounded_relate(std::string_view function, const RoundedView& a, const RoundedView& b);
bool rounded_contains(const RoundedView& outer, const RoundedView& inner);
ExactDistance rounded_exact_distance(const RoundedView& a, const RoundedView& b, Question question);
double rounded_distance_as(const RoundedView& a, const RoundedView& b, Question question);

/// Of what is a figure of a kind; throws Unsupported where a radius is left.
PosedView require_kind(std::string_view function, const RoundedView& s);

/// f of both as they are seen.
template <class A, class B, class F>
auto of_seen(std::string_view function, const A& a, const B& b, const F& f) {
  const auto& x = seen(function, a);
  const auto& y = seen(function, b);
  return f(rounded_view(x), rounded_view(y));
}
/// Such questions take no radius.
template <class A, class B, class F>
auto of_kinds(std::string_view function, const A& a, const B& b, const F& f) {
  return of_seen(function, a, b, [&](const RoundedView& x, const RoundedView& y) {
    return f(require_kind(function, x), require_kind(function, y));
  });
}

template <class A, class B, class F>
auto of_motions(std::string_view function, const Translating<A>& a, const Translating<B>& b, const F& f) {
  return of_seen(function, a.shape, b.shape, [&](const RoundedView& x, const RoundedView& y) {
    return f(PosedMotion{x.figure, a.by, x.radius}, PosedMotion{y.figure, b.by, y.radius});
  });
}

template <class A, class B>
requires OwnPair<A, B>
double distance_as(Question question, const A& a, const B& b) {
  return of_seen(name_of(question), a, b,
                 [&](const RoundedView& x, const RoundedView& y) { return rounded_distance_as(x, y, question); });
}

}  // namespace query

template <class A, class B>
requires query::OwnPair<A, B> Relation relate(const A& a, const B& b) {
  return query::of_seen("relate", a, b, [](const query::RoundedView& x, const query::RoundedView& y) {
    return query::rounded_relate("relate", x, y);
  });
}
template <class A, class B>
requires query::OwnPair<A, B>
bool intersects(const A& a, const B& b) {
  return query::of_seen("intersects", a, b, [](const query::RoundedView& x, const query::RoundedView& y) {
    return query::rounded_relate("intersects", x, y) != Relation::disjoint;
  });
}
template <class Outer, class Inner>
requires query::OwnPair<Outer, Inner>
bool contains(const Outer& outer, const Inner& inner) {
  return query::of_seen("contains", outer, inner, query::rounded_contains);
}

template <class A, class B>
requires query::OwnPair<A, B>
double distance(const A& a, const B& b) { return query::distance_as(query::Question::distance, a, b); }
template <class A, class B>
requires query::OwnPair<A, B> ExactDistance exact_distance(const A& a, const B& b) {
  return query::of_seen("exact_distance", a, b, [](const query::RoundedView& x, const query::RoundedView& y) {
    return query::rounded_exact_distance(x, y, query::Question::exact_distance);
  });
}
/// Of two that have a radius, or one and a round figure, by GJK.
template <class A, class B>
requires query::OwnPair<A, B> Closest closest_points(const A& a, const B& b) {
  return query::of_seen("closest_points", a, b, [&](const query::RoundedView& x, const query::RoundedView& y) {
    if (x.radius == 0 && y.radius == 0) return query::any_closest_points(x.figure, y.figure);
    if constexpr (ConvexBody3<A> && ConvexBody3<B>) {
      return gjk(a, b).closest;
    } else {
      return query::any_closest_points(query::require_kind("closest_points", x),
                                       query::require_kind("closest_points", y));
    }
  });
}

template <class Ray, class Shape>
requires query::OwnPair<Ray, Shape> std::optional<Hit> first_hit(const Ray& ray, const Shape& shape) {
  return query::of_kinds("first_hit", ray, shape, query::any_first_hit);
}
template <class Ray, class Shape>
requires query::OwnPair<Ray, Shape> std::optional<RayParameter> first_hit_parameter(const Ray& ray,
                                                                                    const Shape& shape) {
  return query::of_kinds("first_hit_parameter", ray, shape, query::any_first_hit_parameter);
}
/// The straight figure meets it.
template <class Ray, class Shape>
requires query::OwnPair<Ray, Shape>
bool hits(const Ray& ray, const Shape& shape) {
  return query::of_seen("hits", ray, shape, [](const query::RoundedView& x, const query::RoundedView& y) {
    if (x.radius == 0 && y.radius == 0) return query::any_hits(x.figure, y.figure);
    return query::rounded_relate("hits", x, y) != Relation::disjoint;
  });
}

template <class A, class B>
requires query::OwnPair<A, B> AnyIntersection intersection(const A& a, const B& b) {
  return query::of_kinds("intersection", a, b, query::any_intersection);
}

template <class A, class B>
requires query::OwnPair<A, B> std::optional<Contact> first_contact(const Translating<A>& a, const Translating<B>& b) {
  return query::of_motions("first_contact", a, b, query::any_first_contact);
}
template <class A, class B>
requires query::OwnPair<A, B> std::optional<Root> first_contact_time(const Translating<A>& a, const Translating<B>& b) {
  return query::of_motions("first_contact_time", a, b, query::any_first_contact_time);
}
template <class A, class B>
requires query::OwnPair<A, B>
bool intersects(const Translating<A>& a, const Translating<B>& b) {
  return query::of_motions("intersects", a, b, query::any_meet);
}

/// Of the farthest ball; the feature is the number of its place.
template <RoundedHullFigure Shape>
Support3 support_point(const Shape& s, const Vector3& direction) {
  figure::require_sound("support_point", s, part::axis("direction", direction));
  const query::PlacesAndRadius of = query::places_and_radius(s);
  Support3 far = support_point(of.places, direction);
  if (of.radius > 0) far.point = support_point(Sphere3{far.point, of.radius}, direction).point;
  return far;
}
template <RoundedHullFigure Shape>
double support_value(const Shape& s, const Vector3& direction, Rounding rounding = Rounding::up) {
  figure::require_sound("support_value", s, part::axis("direction", direction));
  const query::PlacesAndRadius of = query::places_and_radius(s);
  const Point3 far = support_point(of.places, direction).point;
  return support_value(Sphere3{far, of.radius}, direction, rounding);
}

}  // namespace plumb
