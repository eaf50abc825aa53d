// What have slabs, and boxes by width or by center, in common with another figure?
//
//   intersection(AabbCenter3{...}, triangle)
//
// Laws: those of query/section/intersection.hpp and solid.hpp, of the sets that the numbers say: boxes by their center in
// every pair that has both Aabb3 and Obb3, those by their widths in every pair of posed boxes, slabs in those of
// intersections of halfspaces.
// NaN and infinity throw NonFinite, by name.
// Source: RTCD 4.6.1, 5.3.
// Cost: that of an Aabb3; where an end is no double that of an Obb3 or of a posed box, and of slabs, rationals.
// Nothing is searched but what intersection of that figure searches (query/section/posed.hpp).
#pragma once

#include "plumb/query/body/restated.hpp"
#include "plumb/query/section/posed.hpp"
#include "plumb/query/section/solid.hpp"

namespace plumb {

namespace query {

template <class A, class B>
concept CutsRestated = RestatedPair<A, B> && requires(const SaidType<A>& a, const SaidType<B>& b) {
  intersection(a, b).kind;
};

}  // namespace query

template <class A, class B>
requires query::CutsRestated<A, B>
auto intersection(const A& a, const B& b) {
  return query::restated("intersection", a, b, [](const auto& p, const auto& q) { return intersection(p, q); });
}

}  // namespace plumb
