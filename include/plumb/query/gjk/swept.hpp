// Swept bodies, moving objects: do two convex bodies that move straight meet on their way, and how near do they come?
//
//   gjk_intersects_moving(a, by_a, b, by_b)      at some time of [0, 1]
//   gjk_distance_moving(a, by_a, b, by_b)        the least distance on the way
//
// Seen from b, a moves by the difference of both vectors, and what it sweeps is the hull of its corners before and after.
// Laws: (1) those of query/gjk/gjk.hpp, of the exact swept set: nothing is rounded, a difference of vectors neither.  (2) A
// motion that both have in common changes nothing.  (3) Without a motion it is gjk_intersects and gjk_distance.
// When they meet first is asked of query/time_of_impact/.
// Source: RTCD 9.5.7.
// Cost: twice that of as many points without neighbors.  Bounded by n^2 signs for n corners of both, on integers as
// long as the exponents' span.
#pragma once

#include "plumb/query/gjk/gjk.hpp"

namespace plumb {

namespace query {

struct SweptBody {
  BodyView body;
  Vector3 by;
};

bool moving_meet(const SweptBody& a, const SweptBody& b);
double moving_apart_by(const SweptBody& a, const SweptBody& b);

}  // namespace query

template <ConvexBody3 A, ConvexBody3 B>
bool gjk_intersects_moving(const A& a, const Vector3& by_a, const B& b, const Vector3& by_b = {0, 0, 0}) {
  return query::moving_meet({query::body_view(a), by_a}, {query::body_view(b), by_b});
}
template <ConvexBody3 A, ConvexBody3 B>
double gjk_distance_moving(const A& a, const Vector3& by_a, const B& b, const Vector3& by_b = {0, 0, 0}) {
  return query::moving_apart_by({query::body_view(a), by_a}, {query::body_view(b), by_b});
}

}  // namespace plumb
