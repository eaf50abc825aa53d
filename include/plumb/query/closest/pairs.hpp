// Closest points of linear primitives: where do two straight shapes come closest, and how near?  Lines, rays, segments
// and triangles, of which none is round.
//
//   closest_points(segment, triangle)    both points, their features, the distance
//   distance(ray, line)                  the number alone; squared_distance_exact without rounding
//   closest_parameters(segment, line)    how far along each the closest points are
//
// Laws: (1) those of query/closest/result.hpp: features exact, of the lowest dimension and then of the lowest number
// that contain the points; numbers rounded once.  (2) Where there are several closest pairs, between parallel shapes or
// within an intersection, they all differ by one vector, and the pair is taken that comes first in lexicographic order
// of coordinates, x before y before z; where none comes first, of rays and lines, the end of the pairs; of two parallel
// lines the first of the pairs that hold a given point.  (3) So the pair depends on the sets of points alone: it is the
// same whichever shape is named first, and whichever corner.  (4) Degenerate shapes are the sets that they are: a line
// or ray of zero direction is its point, and that is its vertex 0; of a triangle without area only vertices and edges
// are named.
// compare_distance (query/closest/closest.hpp) compares any of these.  NaN and infinity throw NonFinite, naming the part.
// Source: RTCD 5.1.8, 5.1.9, 5.1.10, 5.1.11 (figures 5.8 to 5.13); the rule of ties is ours.
// Cost: docs/closest.md.  Bounded by n^2 pairs of features for n corners of both, on integers as long as the
// exponents' span.
#pragma once

#include <array>
#include <concepts>
#include <optional>

#include "plumb/arith/rational.hpp"
#include "plumb/arith/sign.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/query/body/detail/question.hpp"
#include "plumb/query/body/pairs.hpp"
#include "plumb/query/closest/result.hpp"

namespace plumb {

namespace query {

template <class S>
concept StraightFigure = Figure<S> &&
    is_one_of(figure_kind<S>, {FigureKind::line, FigureKind::ray, FigureKind::segment, FigureKind::triangle});
template <StraightFigure S>
inline constexpr bool is_in_space = figure_dimension<S> == 3;

/// In canonical order; query/closest/closest.hpp turns them round.
template <class A, class B>
concept StraightPair = StraightFigure<A> && StraightFigure<B> &&
    (figure_dimension<A> == figure_dimension<B>)&&!OtherWayRound<A, B>;

/// By whose name errors begin.
template <class A, class B>
requires StraightPair<A, B>
double distance_as(Question question, const A& a, const B& b);
template <class A, class B>
requires StraightPair<A, B> Rational squared_distance_as(Question question, const A& a, const B& b);

}  // namespace query

template <class A, class B>
concept StraightPair2 = query::StraightPair<A, B> && !query::is_in_space<A>;
template <class A, class B>
concept StraightPair3 = query::StraightPair<A, B> && query::is_in_space<A>;
template <class A, class B>
concept LinearPair = query::StraightPair<A, B> &&(figure_kind<B> != FigureKind::triangle);

template <class A, class B>
requires StraightPair2<A, B> Closest2 closest_points(const A& a, const B& b);
template <class A, class B>
requires StraightPair3<A, B> Closest closest_points(const A& a, const B& b);

template <class A, class B>
requires query::StraightPair<A, B>
double distance(const A& a, const B& b) { return query::distance_as(query::Question::distance, a, b); }

template <class A, class B>
requires query::StraightPair<A, B> Rational squared_distance_exact(const A& a, const B& b) {
  return query::squared_distance_as(query::Question::squared_distance_exact, a, b);
}

/// s and t of the closest points a.point + s a.direction and b.point + t b.direction; of segments a + s (b - a). Zero
/// where the direction is.
template <class A, class B>
requires LinearPair<A, B> std::array<double, 2> closest_parameters(const A& a, const B& b);
template <class A, class B>
requires(LinearPair<B, A> && !LinearPair<A, B>) std::array<double, 2> closest_parameters(const A& a, const B& b) {
  const auto [t, s] = closest_parameters(b, a);
  return {s, t};
}

namespace query {

/// The distance against a number, where plain doubles prove it.
template <class A, class B>
requires StraightPair<A, B> std::optional<Sign> quick_comparison(const A& a, const B& b, double than);

}  // namespace query

}  // namespace plumb
