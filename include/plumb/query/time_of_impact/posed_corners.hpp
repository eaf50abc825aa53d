// Continuous collision detection under poses: do they meet while every vertex moves linearly from its place under one
// pose to its place under another?  Vertex against triangle, edge against edge.
//
//   first_contact(Moving<Posed<Point3, RigidPose>>{{tip, now}, {tip, next}}, Moving<Triangle3>{floor, floor})
//
// Laws: those of query/time_of_impact/continuous_contact.hpp, of the exact images: the poses of a figure may differ, be
// singular and lead beyond the largest double, and a figure may stand as it is.  A common pose at both times changes no
// feature and no time where its matrix is regular, and of a rigid pose no separation matters.
// Numbers that are none throw NonFinite, the quaternion zero and a negative separation InvalidShape, by name.
// Source: RTCD 3.2, 5.5.
// Cost: below a microsecond where rounded images stay apart; tens of microseconds else, some hundreds with a separation.
// Nothing is searched but what first_contact of the images searches (query/time_of_impact/continuous_contact.hpp).
#pragma once

#include "plumb/query/body/contact_pairs.hpp"
#include "plumb/query/body/posed.hpp"
#include "plumb/query/time_of_impact/continuous_contact.hpp"

namespace plumb {

namespace query {

/// The corners are of one kind of figure: a point, a segment or a triangle of space.
struct CornersInMotion {
  PosedView from, to;
};
/// Of a pair that moving_pairs has.
bool corners_meet(const CornersInMotion& a, const CornersInMotion& b, const ContactOptions& options);
std::optional<Contact> corner_contact(const CornersInMotion& a, const CornersInMotion& b,
                                      const ContactOptions& options);
std::optional<Root> corner_contact_time(const CornersInMotion& a, const CornersInMotion& b,
                                        const ContactOptions& options);

template <class A, class B>
concept PosedCorners = PosedFigures<A, B> && figure_dimension<UnposedType<A>>
== 3 && moving_pairs.answers(figure_kind<UnposedType<A>>, figure_kind<UnposedType<B>>, 3);

template <class Shape>
CornersInMotion corners_in_motion(const Moving<Shape>& s) {
  return {posed_view(s.from), posed_view(s.to)};
}

}  // namespace query

template <class A, class B>
requires query::PosedCorners<A, B>
bool intersects(const Moving<A>& a, const Moving<B>& b, const ContactOptions& options = {}) {
  return query::corners_meet(query::corners_in_motion(a), query::corners_in_motion(b), options);
}
template <class A, class B>
requires query::PosedCorners<A, B> std::optional<Contact> first_contact(const Moving<A>& a, const Moving<B>& b,
                                                                        const ContactOptions& options = {}) {
  return query::corner_contact(query::corners_in_motion(a), query::corners_in_motion(b), options);
}
template <class A, class B>
requires query::PosedCorners<A, B> std::optional<Root> first_contact_time(const Moving<A>& a, const Moving<B>& b,
                                                                          const ContactOptions& options = {}) {
  return query::corner_contact_time(query::corners_in_motion(a), query::corners_in_motion(b), options);
}

}  // namespace plumb
