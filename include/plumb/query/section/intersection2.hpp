// Intersection, clipping: which points do two figures of the plane have in common?
//
//   intersection(Segment2{{0, 0}, {2, 2}}, Segment2{{0, 1}, {2, 0}})   // a point: where the lines cross, unrounded
//   intersection(triangle, other)                                       // nothing, a point, a segment, up to six
//   corners
//
// Lines, rays and segments; triangles, boxes and convex polygons; each with each, in either order.
// Laws: (1) the set of points that both closed sets have in common, in real arithmetic, told as
// query/section/intersection_result.hpp says.  (2) Swapping the figures, naming their corners in another order and powers of
// two change nothing; permuting or translating (where nothing is rounded) moves the set.  (3) Degenerate figures are
// the sets they are: a flat triangle or box is a segment or a point, a box with min > max is nothing, a line of zero
// direction its point.  (4) Corners are held as points as given or as LineLinePoint2, as rational points where a box is
// oriented or no doubles hold the point + direction of a line or ray.
// A polygon that is not convex or has fewer than three vertices throws InvalidShape, NaN and infinity NonFinite.
// Source: RTCD 5.1.9.1, 5.3.3; docs/intersection.md.
// Cost: 17 to 80 ns for segments and triangles in general position; else a microsecond or some, tens where exact
// integers decide.  Bounded by n^2 operations for n corners of both, on integers as long as the exponents' span.
#pragma once

#include "plumb/figure/basic/sound.hpp"
#include "plumb/query/body/answered.hpp"
#include "plumb/query/body/intersection_pairs.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/section/intersection_result.hpp"

namespace plumb {

namespace query {

constexpr bool is_plane_kind(FigureKind kind) {
  return kind == FigureKind::plane || kind == FigureKind::three_point_plane;
}
constexpr bool is_solid_kind(FigureKind kind) {
  return is_one_of(kind, {FigureKind::halfspace, FigureKind::tetrahedron, FigureKind::aabb, FigureKind::obb,
                          FigureKind::k_dop, FigureKind::halfspace_intersection, FigureKind::convex_polyhedron});
}

/// In the order of FigureKind.  Of two planes query/section/planes.hpp tells, of two solids query/section/solid.hpp.
template <class A, class B, int Dimension>
concept SectionPair = Figure<A> && Figure<B> && figure_dimension<A>
== Dimension&& figure_dimension<B> ==
        Dimension&& figure_kind<A> <=
            figure_kind<B>&& intersection_pairs.answers(figure_kind<A>, figure_kind<B>, Dimension) &&
    !(is_plane_kind(figure_kind<A>) && is_plane_kind(figure_kind<B>)) &&
    (Dimension == 2 || !(is_solid_kind(figure_kind<A>) && is_solid_kind(figure_kind<B>)));

Intersection2 common_set2(const FigureView& a, const FigureView& b);
Intersection3 common_set3(const FigureView& a, const FigureView& b);

/// Most figures miss each other, and few signs tell it where a pair has its own.
template <class A, class B>
bool are_parted_by_signs(const A& a, const B& b) {
  if constexpr (method_of<A, B> == PairMethod::signs) {
    return figure::is_sound(a) && figure::is_sound(b) && relate(a, b) == Relation::disjoint;
  } else {
    return false;
  }
}

}  // namespace query

Intersection2 intersection(const Segment2& a, const Segment2& b);
Intersection2 intersection(const Triangle2& a, const Triangle2& b);
template <class A, class B>
requires query::SectionPair<A, B, 2> Intersection2 intersection(const A& a, const B& b) {
  if (query::are_parted_by_signs(a, b)) return {};
  return query::common_set2(query::view_of(a), query::view_of(b));
}

/// The same with the figures named the other way round.
template <class A, class B>
requires(OtherWayRound<A, B>&& requires(const A& a, const B& b) { intersection(b, a); })  //
    auto intersection(const A& a, const B& b) {
  return intersection(b, a);
}

}  // namespace plumb
