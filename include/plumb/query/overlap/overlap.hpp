// Narrow phase: do two figures meet, and do they overlap or only touch?  Every pair of the table (query/body/pairs.hpp,
// docs/overlap.md).
//
// Laws: (1) relate is the relation of figure/basic/relation.hpp between the sets that the numbers say, in real arithmetic:
// they are disjoint, touch where they only have boundary points in common, overlap where their interiors meet, each
// relative to its own affine hull.  (2) intersects is `relate is not disjoint`.  (3) Both are symmetric, and keep their
// answer when vertices are named in another order, and under moves, mirrors and scalings that round nothing.
// (4) Degenerate figures are the sets they are, an empty box meets nothing.  (5) The inside of a polygon is what its
// chains wind around an odd number of times, without the chains; where they lie on one line it is the union of their
// edges, and its inside that of this set on the line.
// NaN and infinities throw NonFinite, naming the function and the part by the kind of its figure ("relate: triangle.b.y
// is nan, ..."), of two of one kind by a and b; a negative radius, a polygon of fewer than three vertices or one that
// is not exactly planar throw InvalidShape.
// Source: RTCD 5.2, 5.2.1.
// Cost: docs/overlap.md.
#pragma once

#include "plumb/arith/error.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"
#include "plumb/figure/obb/obb.hpp"
#include "plumb/figure/sphere/sphere.hpp"
#include "plumb/figure/swept_sphere/swept_sphere.hpp"
#include "plumb/query/body/pairs.hpp"
#include "plumb/query/overlap/box.hpp"
#include "plumb/query/overlap/cylinder_cone.hpp"
#include "plumb/query/overlap/overlap2.hpp"
#include "plumb/query/overlap/plane.hpp"
#include "plumb/query/overlap/round.hpp"
#include "plumb/query/overlap/round2.hpp"
#include "plumb/query/overlap/triangle.hpp"

namespace plumb {

namespace query {

Relation relate_flat(const FlatView& a, const FlatView& b);
bool flat_intersects(const FlatView& a, const FlatView& b);

template <class A, class B>
concept InOrder = RelatedPair<A, B> && !OtherWayRound<A, B>;
template <class A, class B>
concept Turned = RelatedPair<A, B> && OtherWayRound<A, B>;

}  // namespace query

template <class A, class B>
requires(query::InOrder<A, B>&& query::FlatFigure<A>&& query::FlatFigure<B>) Relation relate(const A& a, const B& b) {
  return query::relate_flat(query::view_of(a), query::view_of(b));
}
template <class A, class B>
requires query::Turned<A, B> Relation relate(const A& a, const B& b) { return relate(b, a); }

template <class A, class B>
requires query::InOrder<A, B>
bool intersects(const A& a, const B& b) {
  if constexpr (query::FlatFigure<A> && query::FlatFigure<B> &&
                !query::is_one_of(method_of<A, B>, {PairMethod::signs, PairMethod::bounds, PairMethod::distance})) {
    return query::flat_intersects(query::view_of(a), query::view_of(b));
  } else {
    return relate(a, b, Asked::intersects) != Relation::disjoint;
  }
}
template <class A, class B>
requires query::Turned<A, B>
bool intersects(const A& a, const B& b) { return intersects(b, a); }

}  // namespace plumb
