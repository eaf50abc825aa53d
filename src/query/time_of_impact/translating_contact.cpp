#include "plumb/query/time_of_impact/translating_contact.hpp"

#include "plumb/query/overlap/overlap.hpp"
#include "query/body/figure_input.hpp"
#include "query/time_of_impact/body_meeting.hpp"
#include "query/time_of_impact/quick_motion.hpp"

namespace plumb {
namespace query {
namespace {

template <class A, class B>
Relation relation_of(const A& a, const B& b) {
  return relate(a, b);
}
Relation relation_of(const Point3& p, const Point3& q) { return p == q ? Relation::overlapping : Relation::disjoint; }

template <class A, class B>
Relation start_relation(const BodyMotion& a, const BodyMotion& b) {
  return relation_of(*static_cast<const A*>(a.shape.figure.shape), *static_cast<const B*>(b.shape.figure.shape));
}

template <ContactWanted asked, class A, class B>
concept IsQuick = requires(const Translating<A>& a, const Translating<B>& b) {
  quick::contact<asked>(a, b);
};

/// Has it no radius below zero, nor one that is no number?
bool has_size(const Point3&) { return true; }
bool has_size(const Sphere3& s) { return s.radius >= 0; }

/// Where doubles and pairs of them tell; invalid shapes are left to those who name what is wrong.
template <ContactWanted asked, class A, class B>
quick::Answer quick_answer(const Translating<A>& a, const Translating<B>& b) {
  if constexpr (quick::looks_at_numbers<A, B>) {
    return has_size(a.shape) && has_size(b.shape) ? quick::contact<asked>(a, b) : quick::unsure;
  } else if constexpr (IsQuick<asked, A, B>) {
    if (!(is_sound(a.shape) && is_sound(b.shape) && is_real(sum_of(a.by) + sum_of(b.by)))) return quick::unsure;
    return is_nothing(a.shape) || is_nothing(b.shape) ? quick::no : quick::contact<asked>(a, b);
  } else if constexpr (IsQuick<asked, B, A>) {
    const quick::Answer answer = quick_answer<asked>(b, a);
    return {answer.told, swapped(answer.contact)};
  } else {
    return quick::unsure;
  }
}

// What is not told quickly, out of the way of what is.
template <class A, class B>
[[gnu::noinline]] std::optional<Root> time_of(const Translating<A>& a, const Translating<B>& b) {
  return body_contact_time("first_contact_time", {posed_view(a.shape), &a.by}, {posed_view(b.shape), &b.by},
                           start_relation<A, B>);
}
template <class A, class B>
[[gnu::noinline]] std::optional<Contact> contact_of(const Translating<A>& a, const Translating<B>& b) {
  return body_contact("first_contact", {posed_view(a.shape), &a.by}, {posed_view(b.shape), &b.by},
                      start_relation<A, B>);
}
template <class A, class B>
[[gnu::noinline]] bool meet(const Translating<A>& a, const Translating<B>& b) {
  return bodies_meet("intersects", {posed_view(a.shape), &a.by}, {posed_view(b.shape), &b.by}, start_relation<A, B>);
}

}  // namespace
}  // namespace query

using query::quick::MotionVerdict;

template <class A, class B>
requires MovingPair<A, B> std::optional<Root> first_contact_time(const Translating<A>& a, const Translating<B>& b) {
  if (query::quick_answer<query::ContactWanted::whether>(a, b).told == MotionVerdict::no) return {};
  return query::time_of(a, b);
}

template <class A, class B>
requires MovingPair<A, B> std::optional<Contact> first_contact(const Translating<A>& a, const Translating<B>& b) {
  const auto [told, contact] = query::quick_answer<query::ContactWanted::when>(a, b);
  if (told == MotionVerdict::no) return {};
  if (told == MotionVerdict::yes) return contact;
  if (told == MotionVerdict::starts && query::relation_of(a.shape, b.shape) == Relation::overlapping)
    return query::quick::overlap.contact;
  return query::contact_of(a, b);
}

template <class A, class B>
requires MovingPair<A, B>
bool intersects(const Translating<A>& a, const Translating<B>& b) {
  const MotionVerdict told = query::quick_answer<query::ContactWanted::whether>(a, b).told;
  if (told == MotionVerdict::no || told == MotionVerdict::yes) return told == MotionVerdict::yes;
  if (told == MotionVerdict::starts && query::relation_of(a.shape, b.shape) != Relation::disjoint) return true;
  return query::meet(a, b);
}

#define PLUMB_MOVING_PAIR(A, B)                                                                  \
  template std::optional<Root> first_contact_time(const Translating<A>&, const Translating<B>&); \
  template std::optional<Contact> first_contact(const Translating<A>&, const Translating<B>&);   \
  template bool intersects(const Translating<A>&, const Translating<B>&);
#define PLUMB_MOVING_PAIRS(A)             \
  PLUMB_MOVING_PAIR(A, Point3)            \
  PLUMB_MOVING_PAIR(A, Segment3)          \
  PLUMB_MOVING_PAIR(A, Triangle3)         \
  PLUMB_MOVING_PAIR(A, Aabb3)             \
  PLUMB_MOVING_PAIR(A, Obb3)              \
  PLUMB_MOVING_PAIR(A, ConvexPolyhedron3) \
  PLUMB_MOVING_PAIR(A, Sphere3)           \
  PLUMB_MOVING_PAIR(A, Capsule3)          \
  PLUMB_MOVING_PAIR(A, Plane3)
PLUMB_MOVING_PAIRS(Point3)
PLUMB_MOVING_PAIRS(Segment3)
PLUMB_MOVING_PAIRS(Triangle3)
PLUMB_MOVING_PAIRS(Aabb3)
PLUMB_MOVING_PAIRS(Obb3)
PLUMB_MOVING_PAIRS(ConvexPolyhedron3)
PLUMB_MOVING_PAIRS(Sphere3)
PLUMB_MOVING_PAIRS(Capsule3)
PLUMB_MOVING_PAIR(Plane3, Point3)
PLUMB_MOVING_PAIR(Plane3, Segment3)
PLUMB_MOVING_PAIR(Plane3, Triangle3)
PLUMB_MOVING_PAIR(Plane3, Aabb3)
PLUMB_MOVING_PAIR(Plane3, Obb3)
PLUMB_MOVING_PAIR(Plane3, ConvexPolyhedron3)
PLUMB_MOVING_PAIR(Plane3, Sphere3)
PLUMB_MOVING_PAIR(Plane3, Capsule3)
#undef PLUMB_MOVING_PAIRS
#undef PLUMB_MOVING_PAIR

}  // namespace plumb
