// Containment: does one figure hold every point of another?  Bounding volumes of every kind, and what they bound.
//
//   contains(Obb3{...}, Sphere3{...})       // contains(outer, inner): as closed sets
//
// Outer: halfspaces, convex polygons and triangles, rectangles, tetrahedra, balls, boxes, oriented boxes, capsules,
// lozenges, cylinders, k-DOPs, intersections of halfspaces, convex polyhedra.  Inner: these, and segments, rays, lines,
// any polygon, cones.  Each with each of one space, but cylinders and cones in what is swept by a ball or a disk: how
// far a circle goes from a line is a root of degree four.
// Laws: (1) true exactly when every point of the inner closed set is one of the outer, in real arithmetic: touching
// from inside is held.  (2) Nothing is held by all, and nothing but it is held by an empty figure.  (3) Degenerate
// figures are the sets they are; all holds itself; what is held by what is held is held.
// NaN and infinity throw NonFinite, by name; an outer polygon that is not convex, or not planar, throws InvalidShape.
// Method: an outer figure is convex, so that it holds a hull where it holds what the hull is of: points, balls and
// disks.
// Source: RTCD 4.2, 4.3, 4.4, 4.5, 4.6; Rockafellar, Convex Analysis, 1970.
// Cost: that of locating the corners where doubles hold them; else in rationals: some 20 us for a ball in a box or a
// capsule, 120 us for an oriented box in another, from 0.3 ms on for inner k-DOPs and intersections of halfspaces.
// Bounded by n^2 signs for n corners of both, on integers as long as the exponents' span.
#pragma once

#include "plumb/query/body/contains_pairs.hpp"

namespace plumb {

namespace query {

constexpr bool may_be_outer(FigureKind kind) {
  return is_one_of(kind, {FigureKind::halfspace, FigureKind::triangle, FigureKind::polygon, FigureKind::rectangle,
                          FigureKind::tetrahedron, FigureKind::ball, FigureKind::aabb, FigureKind::obb,
                          FigureKind::capsule, FigureKind::lozenge, FigureKind::cylinder, FigureKind::k_dop,
                          FigureKind::halfspace_intersection, FigureKind::convex_polyhedron});
}
constexpr bool may_be_inner(FigureKind kind) {
  return !is_one_of(kind, {FigureKind::point, FigureKind::plane, FigureKind::three_point_plane});
}
/// Can it be asked whether an outer one holds an inner one?
constexpr bool answers_containment(FigureKind outer, FigureKind inner) {
  const bool swept = is_one_of(outer, {FigureKind::capsule, FigureKind::lozenge, FigureKind::cylinder});
  const bool has_disks = is_one_of(inner, {FigureKind::cylinder, FigureKind::cone});
  return may_be_outer(outer) && may_be_inner(inner) && !(swept && has_disks);
}

template <class Outer, class Inner>
concept ContainmentPair = Figure<Outer> && Figure<Inner> && figure_dimension<Outer>
== figure_dimension<Inner>&& answers_containment(figure_kind<Outer>, figure_kind<Inner>) &&
    contains_pairs.answers(figure_kind<Outer>, figure_kind<Inner>, figure_dimension<Outer>);

bool holds(const FigureView& outer, const FigureView& inner);

}  // namespace query

/// Two of one kind of box, ball, capsule, lozenge or k-DOP go to the headers of these, which are quicker.
template <class Outer, class Inner>
requires query::ContainmentPair<Outer, Inner>
bool contains(const Outer& outer, const Inner& inner) {
  return query::holds(query::view_of(outer), query::view_of(inner));
}

}  // namespace plumb
