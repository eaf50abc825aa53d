// Time of impact in the plane: when do two figures of the plane that move along lines first meet?
//
//   first_contact(Translating<Circle2>{{{0, 0}, 1}, {10, 0}}, floor_plan)
//
// Each is a Point2, Segment2, Triangle2, Aabb2, Obb2, Circle2, Capsule2, Polygon2 or HoledPolygon2, convex or not,
// moving by a vector during time [0, 1]; one of the two may stand still and be given as it is.
// Laws: (1) those of translating_contact.hpp, in the plane: touching is meeting, also in passing; the time is exact, a
// root of a polynomial of degree 2 at most, or rounded down.  (2) Features are those of query/ray/ray2.hpp, and of
// those that meet the ones of the lowest dimensions taken together are told, then of the lowest numbers of the first
// figure, then of the second; {interior, 0} for both where they overlap from the start.  A circle as a whole is
// {edge, 0}, a capsule's ends are vertices and the rest edge 0.  (3) Swapping the figures swaps the features, but where
// several meet at once.  (4) Degenerate figures are the sets that they are; an empty box meets nothing.
// NaN and infinity throw NonFinite, a negative radius and a chain of fewer than three vertices throw InvalidShape, by
// name.
// Source: RTCD 5.5.3 to 5.5.8, in the plane.
// Cost: that of translating_contact.hpp for each pair of a polygon's edges and what it meets.  Bounded by n^2 pairs of
// features for n corners of both, on integers as long as the exponents' span.
#pragma once

#include <optional>

#include "plumb/arith/root.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/query/time_of_impact/motion.hpp"

namespace plumb {

template <MovesInPlane A, MovesInPlane B>
std::optional<Contact> first_contact(const Translating<A>& a, const Translating<B>& b);
template <MovesInPlane A, MovesInPlane B>
std::optional<Root> first_contact_time(const Translating<A>& a, const Translating<B>& b);
template <MovesInPlane A, MovesInPlane B>
bool intersects(const Translating<A>& a, const Translating<B>& b);

/// One of them stands still.
template <MovesInPlane A, MovesInPlane B>
std::optional<Contact> first_contact(const Translating<A>& a, const B& b) {
  return first_contact(a, Translating<B>{b, {0, 0}});
}
template <MovesInPlane A, MovesInPlane B>
std::optional<Contact> first_contact(const A& a, const Translating<B>& b) {
  return first_contact(Translating<A>{a, {0, 0}}, b);
}
template <MovesInPlane A, MovesInPlane B>
std::optional<Root> first_contact_time(const Translating<A>& a, const B& b) {
  return first_contact_time(a, Translating<B>{b, {0, 0}});
}
template <MovesInPlane A, MovesInPlane B>
std::optional<Root> first_contact_time(const A& a, const Translating<B>& b) {
  return first_contact_time(Translating<A>{a, {0, 0}}, b);
}
template <MovesInPlane A, MovesInPlane B>
bool intersects(const Translating<A>& a, const B& b) {
  return intersects(a, Translating<B>{b, {0, 0}});
}
template <MovesInPlane A, MovesInPlane B>
bool intersects(const A& a, const Translating<B>& b) {
  return intersects(Translating<A>{a, {0, 0}}, b);
}

}  // namespace plumb
