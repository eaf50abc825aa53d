// Intersection, clipping: which points have flat figures and oriented boxes of the plane in common with others?
//
// Convex polygons and rectangles in space with lines, rays, segments, planes, halfspaces, triangles, boxes, tetrahedra,
// convex polyhedra and one another; oriented boxes of the plane with lines, rays, segments, triangles, boxes, convex
// polygons and one another; in either order.
// Laws: those of query/section/intersection.hpp; corners of rectangles and oriented boxes, which no doubles hold, are
// held as rational points.  A polygon that is not planar or not convex throws InvalidShape, NaN and infinity NonFinite.
// Source: RTCD 5.3.8, 5.4.
// Cost: microseconds; tens where exact integers decide, as for all oriented boxes and rectangles.  Bounded by n^2
// operations for n corners of both, on integers as long as the exponents' span.
#pragma once

#include <concepts>

#include "plumb/query/section/intersection2.hpp"

namespace plumb {

namespace query {

constexpr bool is_flat_figure(FigureKind kind) { return kind == FigureKind::polygon || kind == FigureKind::rectangle; }
constexpr bool meets_flat_figures(FigureKind kind) {
  return is_one_of(
      kind, {FigureKind::line, FigureKind::ray, FigureKind::segment, FigureKind::plane, FigureKind::three_point_plane,
             FigureKind::halfspace, FigureKind::triangle, FigureKind::polygon, FigureKind::rectangle,
             FigureKind::tetrahedron, FigureKind::aabb, FigureKind::obb, FigureKind::convex_polyhedron});
}
constexpr bool meets_oriented_boxes(FigureKind kind) {
  return is_one_of(kind, {FigureKind::line, FigureKind::ray, FigureKind::segment, FigureKind::triangle,
                          FigureKind::polygon, FigureKind::aabb, FigureKind::obb});
}

/// In the order of FigureKind.
template <class A, class B>
concept FlatPair = Figure<A> && Figure<B> && figure_dimension<A>
== 3 && figure_dimension<B> == 3 && figure_kind<A> <= figure_kind<B>&& meets_flat_figures(figure_kind<A>) &&
    meets_flat_figures(figure_kind<B>) && (is_flat_figure(figure_kind<A>) || is_flat_figure(figure_kind<B>));
template <class A, class B>
concept OrientedBoxPair = Figure<A> && std::same_as<B, Obb2> && figure_dimension<A>
== 2 && meets_oriented_boxes(figure_kind<A>);

Intersection2 common_set2(const FigureView& a, const FigureView& b);
Intersection3 common_set3(const FigureView& a, const FigureView& b);

}  // namespace query

template <class A, class B>
requires query::FlatPair<A, B> Intersection3 intersection(const A& a, const B& b) {
  return query::common_set3(query::view_of(a), query::view_of(b));
}
template <class A, class B>
requires query::OrientedBoxPair<A, B> Intersection2 intersection(const A& a, const B& b) {
  return query::common_set2(query::view_of(a), query::view_of(b));
}

}  // namespace plumb
