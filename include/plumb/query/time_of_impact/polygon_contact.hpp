// Time of impact: when do a ball or a capsule and a polygon in space first meet that move along lines?
//
//   first_contact(Translating{Sphere3{{0, 0, 5}, 1}, {0, 0, -10}}, floor_with_holes)
//
// Quadrilateral3, Polygon3, HoledPolygon3, convex or not, and Rectangle3, against Sphere3 and Capsule3, in either order; one
// of the two may stand still and be given as it is.
// Laws: those of query/time_of_impact/translating_contact.hpp: touching is meeting, the time is exact, a root of a
// polynomial of degree 2 at most, or rounded down; of what meets then the features of the lowest dimensions taken together
// are told, then of the lowest numbers; {interior, 0} for both where they overlap from the start.  A polygon's features
// are those of query/ray/ray.hpp; its inside is that of query/overlap/overlap.hpp.
// NaN and infinity throw NonFinite; a negative radius and a polygon that is not planar throw InvalidShape, by name.
// Method: a ball meets the inside of a polygon before its edges only where it first touches the plane; where that is is
// linear in the time.
// Source: RTCD 5.5.6.
// Cost: that of a segment for each edge, and rationals for the inside, some 20 us.
#pragma once

#include <optional>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"

namespace plumb {

namespace query {

template <class Shape>
concept MovesRound = std::same_as<Shape, Sphere3> || std::same_as<Shape, Capsule3>;
template <class Shape>
concept MovesAsPolygon = std::same_as<Shape, Quadrilateral3> || std::same_as<Shape, Polygon3> ||
    std::same_as<Shape, HoledPolygon3> || std::same_as<Shape, Rectangle3>;

struct PolygonContact {
  Root time;
  Feature on_round, on_polygon;
};
template <MovesRound Round, MovesAsPolygon Shape>
std::optional<PolygonContact> polygon_contact(std::string_view function, const Translating<Round>& round,
                                              const Translating<Shape>& polygon);

template <class A, class B>
concept RoundAndPolygon = (MovesRound<A> && MovesAsPolygon<B>) || (MovesAsPolygon<A> && MovesRound<B>);

template <class A, class B>
std::optional<PolygonContact> polygon_contact_of(std::string_view function, const Translating<A>& a,
                                                 const Translating<B>& b) {
  if constexpr (MovesRound<A>) {
    return polygon_contact(function, a, b);
  } else {
    return polygon_contact(function, b, a);
  }
}

}  // namespace query

template <class A, class B>
requires query::RoundAndPolygon<A, B> std::optional<Contact> first_contact(const Translating<A>& a,
                                                                           const Translating<B>& b) {
  const auto c = query::polygon_contact_of("first_contact", a, b);
  if (!c) return {};
  const Contact contact{c->time.rounded(Rounding::down) + 0.0, c->on_round, c->on_polygon};
  return query::MovesRound<A> ? contact : swapped(contact);
}
template <class A, class B>
requires query::RoundAndPolygon<A, B> std::optional<Contact> first_contact(const Translating<A>& a, const B& b) {
  return first_contact(a, Translating<B>{b, {0, 0, 0}});
}
template <class A, class B>
requires query::RoundAndPolygon<A, B> std::optional<Contact> first_contact(const A& a, const Translating<B>& b) {
  return first_contact(Translating<A>{a, {0, 0, 0}}, b);
}

template <class A, class B>
requires query::RoundAndPolygon<A, B> std::optional<Root> first_contact_time(const Translating<A>& a,
                                                                             const Translating<B>& b) {
  const auto c = query::polygon_contact_of("first_contact_time", a, b);
  return c ? std::optional(c->time) : std::nullopt;
}
template <class A, class B>
requires query::RoundAndPolygon<A, B> std::optional<Root> first_contact_time(const Translating<A>& a, const B& b) {
  return first_contact_time(a, Translating<B>{b, {0, 0, 0}});
}
template <class A, class B>
requires query::RoundAndPolygon<A, B> std::optional<Root> first_contact_time(const A& a, const Translating<B>& b) {
  return first_contact_time(Translating<A>{a, {0, 0, 0}}, b);
}

template <class A, class B>
requires query::RoundAndPolygon<A, B>
bool intersects(const Translating<A>& a, const Translating<B>& b) {
  return query::polygon_contact_of("intersects", a, b).has_value();
}

}  // namespace plumb
