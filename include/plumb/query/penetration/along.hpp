// Penetration by directions given: how far must a convex body move along a direction, one of several, or within a cone
// of them, until it is parted from another?
//
//   penetration_along(a, b, up)                 the least t >= 0 for which a, moved by t * up, is parted from b
//   penetration_along(a, b, directions)         along that of several whose translation is shortest
//   penetration_within(a, b, cone)              by the shortest translation in the cone that the directions span
//
// Parted is what it is for penetration (query/penetration/penetration.hpp): a plane has one body on each side.  A
// game's floor pushes upward, a machine's tool leaves along its axis: the least translation of all is often one that
// cannot be had.
// Laws: (1) exact, then rounded once; `multiple` and `exact_translation` are not rounded.  (2) Bodies that are disjoint
// have none; bodies that are parted as they stand, which touch or are flat in one plane, have depth zero.  (3) Of
// several directions that are as short that one is told which comes first in the list; of several translations within a
// cone the first in lexicographic order, and `is_unique` is false.  (4) A cone is all sums of its directions with
// weights that are not negative: one direction spans a ray, two a sector, three or more a pyramid, six along the axes
// everything; a half-space by four.  Every direction leads out in the end.  (5) The features are as in penetration: of
// the plane that the translation ends at, of several such planes of the one through which penetration would rather
// leave; at depth zero those of penetration.  (6) Balls, capsules and lozenges are their cores and a radius: they leave
// along a direction at the root of a quadratic polynomial, which `multiple` is then; a round body of radius zero leaves
// as its core does.  A cone takes bodies without a radius: within a sector the shortest way out of what is round ends
// at roots of degree four, each local, and of all edges and vertices of the difference one of these may be the least.
// A direction of length zero, and none at all, throws InvalidShape, NaN and infinity NonFinite, by name.
// Source: RTCD 9.3.8, 9.5; van den Bergen 2001, of round bodies 2004; Cameron 1997 for translational distances by
// directions.
// Cost: that of exact_penetration, for each direction; of a cone of n directions n^3 signs a facet of the polytope; of
// round bodies some tens of microseconds a direction.  Bounded by n^2 log n signs a direction for n corners of both, on
// integers as long as the exponents' span.
#pragma once

#include <span>

#include "plumb/arith/root.hpp"
#include "plumb/query/penetration/penetration.hpp"

namespace plumb {

struct PenetrationAlong {
  std::size_t index;  // of the direction
  Rational multiple;  // of the direction
  double depth;       // the length of the translation
  Vector3 translation;
  Feature feature_a, feature_b;
};

/// Where a body has a radius.
struct RoundPenetrationAlong {
  std::size_t index;  // of the direction
  Root multiple;      // of the direction
  double depth;       // the length of the translation
  Vector3 translation;
  Feature feature_a, feature_b;
};

/// All sums of these with weights that are not negative.
struct DirectionCone3 {
  std::span<const Vector3> directions;
};

struct PenetrationWithin {
  ExactVector3 exact_translation;
  Rational square;  // of its length
  double depth;
  Vector3 translation;
  Feature feature_a, feature_b;
  bool is_unique;
};

namespace query {

template <class Shape>
constexpr bool is_of_straight_kind() {
  if constexpr (is_vertex_hull<Shape>) {
    return true;
  } else if constexpr (is_body_figure<Shape>) {
    return !is_one_of(figure_kind<Shape>, {FigureKind::ball, FigureKind::capsule, FigureKind::lozenge});
  } else {
    return false;  // it may have a radius
  }
}
template <class Shape>
inline constexpr bool is_straight_body = is_of_straight_kind<UnposedType<Shape>>();

std::optional<PenetrationAlong> penetration_along_of(const BodyView& a, const BodyView& b,
                                                     std::span<const Vector3> directions, bool is_list);
std::optional<RoundPenetrationAlong> round_penetration_along_of(const BodyView& a, const BodyView& b,
                                                                std::span<const Vector3> directions, bool is_list);
std::optional<PenetrationWithin> penetration_within_of(const BodyView& a, const BodyView& b,
                                                       const DirectionCone3& cone);

}  // namespace query

/// A convex body whose radius is zero because its kind has none.
template <class Shape>
concept StraightBody3 = ConvexBody3<Shape> && query::is_straight_body<Shape>;

template <StraightBody3 A, StraightBody3 B>
std::optional<PenetrationAlong> penetration_along(const A& a, const B& b, const Vector3& direction) {
  return query::penetration_along_of(query::body_view(a), query::body_view(b), {&direction, 1}, false);
}

template <StraightBody3 A, StraightBody3 B>
std::optional<PenetrationAlong> penetration_along(const A& a, const B& b, std::span<const Vector3> directions) {
  return query::penetration_along_of(query::body_view(a), query::body_view(b), directions, true);
}

/// Of bodies one of which is of a kind that has a radius.
template <ConvexBody3 A, ConvexBody3 B>
requires(!StraightBody3<A> || !StraightBody3<B>)  //
    std::optional<RoundPenetrationAlong> penetration_along(const A& a, const B& b, const Vector3& direction) {
  return query::round_penetration_along_of(query::body_view(a), query::body_view(b), {&direction, 1}, false);
}

template <ConvexBody3 A, ConvexBody3 B>
requires(!StraightBody3<A> || !StraightBody3<B>)  //
    std::optional<RoundPenetrationAlong> penetration_along(const A& a, const B& b,
                                                           std::span<const Vector3> directions) {
  return query::round_penetration_along_of(query::body_view(a), query::body_view(b), directions, true);
}

template <StraightBody3 A, StraightBody3 B>
std::optional<PenetrationWithin> penetration_within(const A& a, const B& b, const DirectionCone3& cone) {
  return query::penetration_within_of(query::body_view(a), query::body_view(b), cone);
}

}  // namespace plumb
