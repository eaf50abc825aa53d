// Narrow phase: do two figures meet, and do they overlap or only touch?  Every pair of the table (query/body/pairs.hpp,
// docs/overlap.md).
//
//   relate(segment, box)         disjoint, touching or overlapping
//   intersects(box, segment)     relate is not disjoint
//
// Laws: (1) relate is the relation of figure/basic/relation.hpp between the sets that the numbers say, in real arithmetic:
// they are disjoint, touch where they only have boundary points in common, overlap where their interiors meet, each
// relative to its own affine hull.  (2) intersects is `relate is not disjoint`.  (3) Both are symmetric, and keep their
// answer when vertices are named in another order, and under moves, mirrors and scalings that round nothing.
// (4) Degenerate figures are the sets they are: a ray of zero direction is its origin, a triangle may be a segment, an
// oriented box is the parallelepiped of its axes, a capsule of equal ends a ball, a plane of zero normal all of space or
// nothing, three points that span no plane their line; an empty box meets nothing.  (5) The inside of a polygon is what
// its chains wind around an odd number of times, without the chains; where they lie on one line it is the union of their
// edges, and its inside that of this set on the line, so that a ball can only touch it.  (6) What lies in a plane
// overlaps it, and touches the halfspaces that it bounds.
// NaN and infinities throw NonFinite, by the kind of the figure ("relate: triangle.b.y is nan, ..."), of two of one kind
// by a and b; a negative radius, a polygon of fewer than three vertices or one that is not exactly planar, a k-DOP of other
// ends throw InvalidShape.  Where doubles decide, a polyhedron is what convex_polyhedron made, and is not looked through.
// Two bounds of one kind are answered where they are declared: figure/aabb/relation.hpp, obb.hpp, sphere.hpp, ...
// Source: RTCD 4.3, 4.5.1, 5.1.9.1, 5.2, 5.2.1, 5.2.2, 5.2.3, 5.2.4, 5.2.5, 5.2.6, 5.2.7, 5.2.8, 5.2.9, 5.2.10, 5.3.1,
// 5.3.2, 5.3.3, 5.3.4, 5.3.6, 5.3.7; Guigue and Devillers 2003; Akenine-Moller 2001.
// Cost: docs/overlap.md: some 5 to 30 ns where doubles decide of boxes, triangles and what is straight, to 200 ns of
// round figures; integers or rationals where figures touch or all but do.  Bounded by n^2 signs for n corners of both,
// on integers as long as the exponents' span.
#pragma once

#include "plumb/arith/error.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"
#include "plumb/figure/obb/obb.hpp"
#include "plumb/figure/sphere/sphere.hpp"
#include "plumb/figure/swept_sphere/swept_sphere.hpp"
#include "plumb/query/body/pairs.hpp"
#include "plumb/query/overlap/detail/at_once.hpp"
#include "plumb/query/overlap/detail/pair_function.hpp"

namespace plumb {

namespace query {

Relation relate_flat(const FlatView& a, const FlatView& b);
bool flat_intersects(const FlatView& a, const FlatView& b);

/// Two that no folder below answers.
template <class A, class B>
concept PairOfTable = RelatedPair<A, B> &&(method_of<A, B> != PairMethod::bounds);

/// By a function of the pair's own; otherwise by what is known of all figures with straight edges.
template <class A, class B>
inline constexpr bool has_own_way = is_one_of(method_of<A, B>, {PairMethod::signs, PairMethod::distance});

/// By whose name errors begin.  Where it is not relate, any relation but disjoint is an answer.
template <class A, class B>
requires PairOfTable<A, B> Relation relate_as(Question question, const A& a, const B& b) {
  if constexpr (OtherWayRound<A, B>) {
    return relate_as(question, b, a);
  } else if constexpr (!has_own_way<A, B>) {
    return relate_flat(view_of(a), view_of(b));
  } else {
    const auto exactly = [&] { return relate_pair(PairFunction<A, B>(), a, b, question); };
    if constexpr (requires { at_once(a, b, exactly); }) {
      return at_once(a, b, exactly);
    } else {
      return exactly();
    }
  }
}

}  // namespace query

template <class A, class B>
requires query::PairOfTable<A, B> Relation relate(const A& a, const B& b) {
  return query::relate_as(query::Question::relate, a, b);
}

template <class A, class B>
requires query::PairOfTable<A, B>
bool intersects(const A& a, const B& b) {
  if constexpr (OtherWayRound<A, B>) {
    return intersects(b, a);
  } else if constexpr (query::has_own_way<A, B>) {
    return query::relate_as(query::Question::intersects, a, b) != Relation::disjoint;
  } else {
    return query::flat_intersects(query::view_of(a), query::view_of(b));
  }
}

}  // namespace plumb
