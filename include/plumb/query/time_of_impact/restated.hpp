// Swept test of boxes by width or by center: when do they first meet another figure, moving along lines?
//
//   first_contact(Translating{AabbCenter3{...}, {10, 0, 0}}, wall)
//
// Laws: those of query/time_of_impact/translating_contact.hpp, of the sets that the numbers say, in every pair that has
// Aabb3.  A slab is no figure of that table: it is met when the later of its two planes is passed, each a Plane3.
// NaN and infinity throw NonFinite, by name.
// Source: RTCD 4.2 (figure 4.3), 5.5.
// Cost: that of an Aabb3; where an end is no double that of an Obb3, or of a posed box, some 50 us.  Nothing is
// searched but what first_contact of that figure searches (query/time_of_impact/posed.hpp).
#pragma once

#include "plumb/query/body/restated.hpp"
#include "plumb/query/time_of_impact/posed.hpp"

namespace plumb {

namespace query {

template <class A, class B>
concept MovesRestated = RestatedPair<A, B> && AnyMovingPair<UnposedType<SaidType<A>>, UnposedType<SaidType<B>>>;

/// `ask` of both moving figures.
template <class A, class B, class Ask>
auto restated_motion(std::string_view function, const Translating<A>& a, const Translating<B>& b, const Ask& ask) {
  return restated(function, a.shape, b.shape, [&](const auto& p, const auto& q) {
    return ask(Translating{p, a.by}, Translating{q, b.by});
  });
}

}  // namespace query

template <class A, class B>
requires query::MovesRestated<A, B> std::optional<Contact> first_contact(const Translating<A>& a,
                                                                         const Translating<B>& b) {
  return query::restated_motion("first_contact", a, b,
                                [](const auto& p, const auto& q) { return first_contact(p, q); });
}

template <class A, class B>
requires query::MovesRestated<A, B> std::optional<Root> first_contact_time(const Translating<A>& a,
                                                                           const Translating<B>& b) {
  return query::restated_motion("first_contact_time", a, b,
                                [](const auto& p, const auto& q) { return first_contact_time(p, q); });
}

template <class A, class B>
requires query::MovesRestated<A, B>
bool intersects(const Translating<A>& a, const Translating<B>& b) {
  return query::restated_motion("intersects", a, b, [](const auto& p, const auto& q) { return intersects(p, q); });
}

}  // namespace plumb
