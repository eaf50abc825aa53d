// Closest points of slabs and of boxes by width or by center: where do they come closest to another figure?
//
//   distance(Slab3{normal, 1, 2}, capsule)
//
// Laws: those of query/separation/separation.hpp, of the sets that the numbers say, in every pair that closest_points
// takes of Aabb3 and of intersections of halfspaces.  A box has the features of an Aabb3; a slab is face 0 at its min and
// face 1 at its max, edges in the plane.
// An empty slab throws InvalidShape, NaN and infinity NonFinite, by name.
// Source: RTCD 4.6.1, 5.1, 5.1.3.
// Cost: that of an Aabb3; of a slab, and of a box whose ends are no doubles, rationals: some 100 us.  Nothing is
// searched but what closest_points of that figure searches (query/separation/posed.hpp).
#pragma once

#include "plumb/query/body/restated.hpp"
#include "plumb/query/separation/posed.hpp"

namespace plumb {

namespace query {

template <class A, class B>
concept NearRestated = RestatedPair<A, B> && requires(const SaidType<A>& a, const SaidType<B>& b) {
  closest_points(a, b).on_a;
  { distance(a, b) } -> std::same_as<double>;
};

template <class A, class B>
requires NearRestated<A, B>
double distance_as(Question question, const A& a, const B& b) {
  return restated(name_of(question), a, b, [](const auto& p, const auto& q) { return distance(p, q); });
}

}  // namespace query

template <class A, class B>
requires query::NearRestated<A, B>
auto closest_points(const A& a, const B& b) {
  return query::restated("closest_points", a, b, [](const auto& p, const auto& q) { return closest_points(p, q); });
}

template <class A, class B>
requires query::NearRestated<A, B>
double distance(const A& a, const B& b) { return query::distance_as(query::Question::distance, a, b); }

template <class A, class B>
requires query::NearRestated<A, B> ExactDistance exact_distance(const A& a, const B& b) {
  return query::restated("exact_distance", a, b, [](const auto& p, const auto& q) { return exact_distance(p, q); });
}

}  // namespace plumb
