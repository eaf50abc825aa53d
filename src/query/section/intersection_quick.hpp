// Intersection: which pairs need no sets of bounds?  Those that a few signs part, and those that cross in one point
// inside of both.
//
// Laws: what is answered is exact; nothing where signs are zero that leave a choice, and the general way has to tell.
// Source: RTCD 5.1.9.1, 5.3.4, 5.3.6, 5.2.10.
// Cost: 5 to 100 ns, and the allocation of what is in common.
#pragma once

#include <optional>

#include "plumb/predicates.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/section/intersection.hpp"
#include "query/body/figure_input.hpp"
#include "query/section/meet.hpp"

namespace plumb::query::meeting {

template <class A, class B>
using Common = decltype(intersection(std::declval<A>(), std::declval<B>()));

/// By doubles, whatever they are; for figures of which nothing is known the general way tells.
template <class A, class B>
std::optional<Common<A, B>> quick(const A&, const B&) {
  return {};
}
std::optional<Intersection2> quick(const Segment2& s, const Segment2& t);
std::optional<Intersection2> quick(const Triangle2& t, const Triangle2& u);
std::optional<Intersection3> quick(const Segment3& s, const Triangle3& t);
std::optional<Intersection3> quick(const Triangle3& t, const Triangle3& u);

/// By exact signs, of real numbers: most figures miss each other, and few signs tell where a pair has its own.
template <class A, class B>
std::optional<Common<A, B>> by_signs(const A& a, const B& b) {
  if constexpr (method_of<A, B> == PairMethod::signs) {
    if (relate(a, b) == Relation::disjoint) return Common<A, B>{};
  }
  return {};
}

std::optional<Intersection2> by_signs(const Segment2& s, const Segment2& t);
std::optional<Intersection3> by_signs(const Segment3& s, const Triangle3& t);
std::optional<Intersection3> by_signs(const Triangle3& t, const Triangle3& u);
std::optional<Intersection3> by_signs(const Triangle3& t, const Aabb3& b);

/// In that order, and of others the general way.
template <class A, class B>
Common<A, B> intersection_of(const A& a, const B& b) {
  if (auto told = quick(a, b)) return std::move(*told);
  query::require_figures("intersection", a, b);
  if (auto told = by_signs(a, b)) return std::move(*told);
  return meet(convex_set(a), convex_set(b));
}

}  // namespace plumb::query::meeting
