// Intersection, clipping: which points do two figures of the plane have in common?
//
//   intersection(Segment2{{0, 0}, {2, 2}}, Segment2{{0, 1}, {2, 0}})   // a point: where the lines cross, unrounded
//   intersection(triangle, other)                                       // nothing, a point, a segment, up to six
//   corners
//
// Lines, rays and segments; triangles, axis-aligned boxes and convex polygons; each with each, in either order.
// Laws: (1) the set of points that both closed sets have in common, in real arithmetic, told as
// query/section/intersection_result.hpp says.  (2) Swapping the figures, naming their corners in another order and powers of
// two change nothing; permuting or translating (where nothing is rounded) moves the set.  (3) Degenerate figures are
// the sets they are: a flat triangle or box is a segment or a point, a box with min > max is nothing, a line of zero
// direction its point.  (4) Corners are held as points as given or as LineLinePoint2 unless the figure is a line or
// ray whose point + direction no doubles hold.
// A polygon that is not convex or has fewer than three vertices throws InvalidShape, NaN and infinity NonFinite.
// Source: RTCD 5.1.9.1, 5.3.3; docs/intersection.md.
// Cost: 17 to 80 ns for segments and triangles in general position; else a microsecond or some, tens where exact
// integers decide.  Bounded by n^2 operations for n corners of both, on integers as long as the exponents' span.
#pragma once

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/query/body/answered.hpp"
#include "plumb/query/body/pairs.hpp"
#include "plumb/query/section/intersection_result.hpp"

namespace plumb {

Intersection2 intersection(const Line2& a, const Line2& b);
Intersection2 intersection(const Line2& a, const Ray2& b);
Intersection2 intersection(const Line2& a, const Segment2& b);
Intersection2 intersection(const Line2& a, const Triangle2& b);
Intersection2 intersection(const Line2& a, const Polygon2& b);
Intersection2 intersection(const Line2& a, const Aabb2& b);
Intersection2 intersection(const Ray2& a, const Ray2& b);
Intersection2 intersection(const Ray2& a, const Segment2& b);
Intersection2 intersection(const Ray2& a, const Triangle2& b);
Intersection2 intersection(const Ray2& a, const Polygon2& b);
Intersection2 intersection(const Ray2& a, const Aabb2& b);
Intersection2 intersection(const Segment2& a, const Segment2& b);
Intersection2 intersection(const Segment2& a, const Triangle2& b);
Intersection2 intersection(const Segment2& a, const Polygon2& b);
Intersection2 intersection(const Segment2& a, const Aabb2& b);
Intersection2 intersection(const Triangle2& a, const Triangle2& b);
Intersection2 intersection(const Triangle2& a, const Polygon2& b);
Intersection2 intersection(const Triangle2& a, const Aabb2& b);
Intersection2 intersection(const Polygon2& a, const Polygon2& b);
Intersection2 intersection(const Polygon2& a, const Aabb2& b);
Intersection2 intersection(const Aabb2& a, const Aabb2& b);

/// The same with the figures named the other way round.
template <class A, class B>
requires(OtherWayRound<A, B>&& requires(const A& a, const B& b) { intersection(b, a); })  //
    auto intersection(const A& a, const B& b) {
  return intersection(b, a);
}

}  // namespace plumb
