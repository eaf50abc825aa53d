// Swept test of moved figures: when do figures under poses, which move along lines, first meet?
//
//   first_contact(Translating{Posed{box, pose}, {10, 0, 0}}, wall)
//
// The pose is where the figure stands; it moves by the vector as given.
// Laws: those of query/time_of_impact/translating_contact.hpp, of the exact images, in every pair of theirs, one or both
// posed, in either order.  What a singular matrix flattens is the flat figure that it becomes; features keep the numbers
// that they have without the pose.  Balls and capsules take poses whose columns are at right angles and of one length
// that is a double, exactly, and planes those that are not singular: UnevenPose else.
// Source: RTCD 3.2, 5.5.
// Cost: some 50 us for two boxes.
#pragma once

#include "plumb/query/body/posed.hpp"
#include "plumb/query/time_of_impact/translating_contact.hpp"

namespace plumb {

namespace query {

struct PosedMotion {
  PosedView figure;
  const Vector3* by;
};
std::optional<Contact> posed_contact(const PosedMotion& a, const PosedMotion& b);
std::optional<Root> posed_contact_time(const PosedMotion& a, const PosedMotion& b);
bool posed_bodies_meet(const PosedMotion& a, const PosedMotion& b);

template <class A, class B>
concept PosedMovingPair = PosedFigures<A, B> && MovingPair<UnposedType<A>, UnposedType<B>>;

inline constexpr Vector3 no_motion{0, 0, 0};
template <class Shape>
PosedMotion posed_motion(const Shape& s) {
  return {posed_view(s), &no_motion};
}
template <class Shape>
PosedMotion posed_motion(const Translating<Shape>& s) {
  return {posed_view(s.shape), &s.by};
}

}  // namespace query

template <class A, class B>
requires query::PosedMovingPair<A, B> std::optional<Contact> first_contact(const Translating<A>& a,
                                                                           const Translating<B>& b) {
  return query::posed_contact(query::posed_motion(a), query::posed_motion(b));
}
template <class A, class B>
requires query::PosedMovingPair<A, B> std::optional<Contact> first_contact(const Translating<A>& a, const B& b) {
  return query::posed_contact(query::posed_motion(a), query::posed_motion(b));
}
template <class A, class B>
requires query::PosedMovingPair<A, B> std::optional<Contact> first_contact(const A& a, const Translating<B>& b) {
  return query::posed_contact(query::posed_motion(a), query::posed_motion(b));
}

template <class A, class B>
requires query::PosedMovingPair<A, B> std::optional<Root> first_contact_time(const Translating<A>& a,
                                                                             const Translating<B>& b) {
  return query::posed_contact_time(query::posed_motion(a), query::posed_motion(b));
}
template <class A, class B>
requires query::PosedMovingPair<A, B> std::optional<Root> first_contact_time(const Translating<A>& a, const B& b) {
  return query::posed_contact_time(query::posed_motion(a), query::posed_motion(b));
}
template <class A, class B>
requires query::PosedMovingPair<A, B> std::optional<Root> first_contact_time(const A& a, const Translating<B>& b) {
  return query::posed_contact_time(query::posed_motion(a), query::posed_motion(b));
}

template <class A, class B>
requires query::PosedMovingPair<A, B>
bool intersects(const Translating<A>& a, const Translating<B>& b) {
  return query::posed_bodies_meet(query::posed_motion(a), query::posed_motion(b));
}
template <class A, class B>
requires query::PosedMovingPair<A, B>
bool intersects(const Translating<A>& a, const B& b) {
  return query::posed_bodies_meet(query::posed_motion(a), query::posed_motion(b));
}
template <class A, class B>
requires query::PosedMovingPair<A, B>
bool intersects(const A& a, const Translating<B>& b) {
  return query::posed_bodies_meet(query::posed_motion(a), query::posed_motion(b));
}

}  // namespace plumb
