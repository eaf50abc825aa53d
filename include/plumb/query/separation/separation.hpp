// Closest points, separation: how far apart are two figures, whatever they are, and where do they come closest?
//
//   closest_points(box, polyhedron)      both points, their features, the distance
//   closest_points(box, polyhedron, WhichPair::first)   of figures that meet the first common point
//   distance(capsule, oriented_box)      the number; exact_distance without any rounding, squared_distance_exact where
//                                        neither is round
//   compare_distance(ball, box, 3.0)     exactly (query/closest/closest.hpp)
//
// All pairs of figures of one space (query/body/pairs.hpp) that query/closest/ has not, but for cylinders and cones.
// Laws: (1) those of query/closest/result.hpp: coordinates and distances are the exact values, each rounded once.
// (2) Figures that meet are at distance 0, and both points are one that they have in common: any, for which both features
// may be the interior, or with `WhichPair::first` the one which comes first in lexicographic order of coordinates.
// (3) Where there are several closest pairs of figures that are apart, of parallel faces, that one is told which comes first;
// of two polygons, whose pairs need not differ by one vector, that with the earliest point.  Where none comes first, of
// figures that go on, it is one of them.  (4) Round figures have the points of their cores' pair, moved toward one another by
// the radii; where they meet and the cores do not, the one that divides the way between these two as the radii do.
// (5) Whichever figure is named first, the answer is the same, turned round, but for any common point.  (6) A feature is
// that of the lowest dimension and then of the lowest number that holds the exact point; k-DOPs and intersections of
// halfspaces have sides alone: 2 times the direction, plus 1 at its upper end; the number of the halfspace.  (7) Degenerate
// figures are the sets that they are.
// NaN and infinity throw NonFinite, an empty figure, a negative radius and a polygon that is not planar InvalidShape, by
// name.  Where doubles decide, a polyhedron is what convex_polyhedron made, and is not looked through.
// Source: RTCD 5.1.8, 5.1.9, 5.1.10, 5.1.11; Gilbert, Johnson and Keerthi 1988; Wolfe 1976.
// Cost: docs/closest.md.  Bounded by n^2 signs for n corners of both, on integers as long as the exponents' span: no
// simplex comes twice.
#pragma once

#include "plumb/query/body/closest_pairs.hpp"
#include "plumb/query/closest/closest.hpp"
#include "plumb/query/closest/which_pair.hpp"

namespace plumb {

namespace query {

/// In canonical order; query/closest/closest.hpp turns them round.
template <class A, class B>
concept SeparatedPair = Figure<A> && Figure<B> &&(figure_dimension<A> == figure_dimension<B>)&&!OtherWayRound<A, B> &&
                        closest_pairs.answers(figure_kind<A>, figure_kind<B>, figure_dimension<A>) &&
                        !StraightPair<A, B> && !(AnyOf<A, Point2, Point3> && (NearPoint2<B> || NearPoint3<B>));

template <class S>
inline constexpr bool is_round = is_one_of(figure_kind<S>,
                                           {FigureKind::ball, FigureKind::capsule, FigureKind::lozenge});

/// `common`: which common point of figures that meet.
Closest closest_points_of(const FigureView& a, const FigureView& b, WhichPair common = WhichPair::first);
double distance_of(const FigureView& a, const FigureView& b, Question question);
/// At a time of two straight motions, in real arithmetic.
double distance_of_moved(const FigureView& a, const Vector3& by_a, const FigureView& b, const Vector3& by_b,
                         double time, std::string_view function);
ExactDistance exact_distance_of(const FigureView& a, const FigureView& b, Question question);

template <class A, class B>
requires SeparatedPair<A, B>
double distance_as(Question question, const A& a, const B& b) { return distance_of(view_of(a), view_of(b), question); }

}  // namespace query

template <class A, class B>
concept SeparatedPair2 = query::SeparatedPair<A, B> && figure_dimension<A>
== 2;
template <class A, class B>
concept SeparatedPair3 = query::SeparatedPair<A, B> && figure_dimension<A>
== 3;

template <class A, class B>
requires SeparatedPair3<A, B> Closest closest_points(const A& a, const B& b, WhichPair common = WhichPair::any) {
  return query::closest_points_of(query::view_of(a), query::view_of(b), common);
}
template <class A, class B>
requires SeparatedPair2<A, B> Closest2 closest_points(const A& a, const B& b, WhichPair common = WhichPair::any) {
  const Closest c = query::closest_points_of(query::view_of(a), query::view_of(b), common);
  return {{c.on_a.x, c.on_a.y}, {c.on_b.x, c.on_b.y}, c.distance, c.feature_a, c.feature_b};
}

template <class A, class B>
requires(OtherWayRound<A, B>&& query::SeparatedPair<B, A>)  //
    auto closest_points(const A& a, const B& b, WhichPair common) {
  return swapped(closest_points(b, a, common));
}

template <class A, class B>
requires query::SeparatedPair<A, B>
double distance(const A& a, const B& b) { return query::distance_as(query::Question::distance, a, b); }

template <class A, class B>
requires query::SeparatedPair<A, B> ExactDistance exact_distance(const A& a, const B& b) {
  return query::exact_distance_of(query::view_of(a), query::view_of(b), query::Question::exact_distance);
}

/// Of two figures neither of which is round.
template <class A, class B>
requires(query::SeparatedPair<A, B> && !query::is_round<A> && !query::is_round<B>)  //
    Rational squared_distance_exact(const A& a, const B& b) {
  return query::exact_distance_of(query::view_of(a), query::view_of(b), query::Question::squared_distance_exact).square;
}

}  // namespace plumb
