// Fat figures: all that is within a radius of a figure, by name.  A tolerance that is part of the shape, decided exactly.
//
//   relate(Fat{segment, 0.01}, triangle)           within 0.01 of one another?
//   intersects(Fat{polygon, 1}, Fat{box, 2})
//   contains(Fat{polyhedron, 0.5}, p)
//
// A line that is tested against two triangles with a common edge passes neither, where their fat ones overlap: what slips
// through a crack that rounding has made does not slip through these.  A fat point is a ball, a fat segment a capsule.
// Laws: (1) the closed set of all points at most so far from the figure, in real arithmetic.  Two meet where their figures
// are no farther apart than both radii together, touch where they are exactly as far, and overlap where less; with both
// radii zero it is relate of the figures.  Of a polygon's edges that bound no inside nothing else is said here.  (2) relate is symmetric, intersects is `relate is not disjoint`.
// Every pair of figures that exact_distance takes, one fat or both, in the plane and in space.
// A negative radius and an empty figure throw InvalidShape, NaN and infinity NonFinite, by name.
// Source: RTCD 11.3.4, 4.5.
// Cost: that of exact_distance (docs/closest.md).  Nothing is searched but what exact_distance searches
// (query/separation/separation.hpp).
#pragma once

#include "plumb/query/separation/separation.hpp"

namespace plumb {

template <class Shape>
struct Fat {
  Shape shape;
  double radius;
  friend bool operator==(const Fat&, const Fat&) = default;
};
template <class Shape>
Fat(Shape, double) -> Fat<Shape>;

namespace query {

template <class Shape>
struct FatOf {
  using Type = Shape;
  static constexpr bool is_fat = false;
};
template <class Shape>
struct FatOf<Fat<Shape>> {
  using Type = Shape;
  static constexpr bool is_fat = true;
};
template <class Shape>
using ThinType = typename FatOf<Shape>::Type;

template <class A, class B>
concept FatPair = (FatOf<A>::is_fat || FatOf<B>::is_fat) && Figure<ThinType<A>>&& Figure<ThinType<B>>&& requires(
                                                                const ThinType<A>& a, const ThinType<B>& b) {
  exact_distance(a, b);
};

void require_fat_radius(std::string_view function, double radius);

template <class Shape>
const ThinType<Shape>& thin(const Shape& s) {
  if constexpr (FatOf<Shape>::is_fat) {
    return s.shape;
  } else {
    return s;
  }
}
template <class Shape>
double fat_radius(std::string_view function, const Shape& s) {
  if constexpr (FatOf<Shape>::is_fat) {
    require_fat_radius(function, s.radius);
    return s.radius;
  } else {
    return 0;
  }
}

template <class A, class B>
Relation relate_fat(std::string_view function, const A& a, const B& b) {
  const double r = fat_radius(function, a), s = fat_radius(function, b);
  if constexpr (requires { relate(thin(a), thin(b)); }) {
    if (r == 0 && s == 0) return relate(thin(a), thin(b));
  }
  ExactDistance d = exact_distance(thin(a), thin(b));
  d.inset = d.inset + Rational(r) + Rational(s);
  // Of sets that meet or nearly do the distance is zero, whether they touch: the square against that of the reach.
  const auto order = d.square <=> d.inset * d.inset;
  return order > 0 ? Relation::disjoint : order < 0 ? Relation::overlapping : Relation::touching;
}

}  // namespace query

template <class A, class B>
requires query::FatPair<A, B> Relation relate(const A& a, const B& b) { return query::relate_fat("relate", a, b); }

template <class A, class B>
requires query::FatPair<A, B>
bool intersects(const A& a, const B& b) { return query::relate_fat("intersects", a, b) != Relation::disjoint; }

/// Of a point.
template <class Shape, class Point>
requires(query::FatPair<Fat<Shape>, Point>&& figure_kind<Point> == FigureKind::point)  //
    bool contains(const Fat<Shape>& fat, const Point& p) {
  return query::relate_fat("contains", fat, p) != Relation::disjoint;
}

}  // namespace plumb
