// Intersection, clipping: which points do two figures have in common?  Nothing, a point, a segment or a polygon, with
// exact corners.
//
//   const Intersection3 common = intersection(triangle, other);
//   if (common.kind == IntersectionKind::segment) orient3d(common.vertices[0], a, b, c);   // exact
//   approximate(common);                                                                     // the nearest doubles
//
// Lines, rays and segments with each other, with planes, halfspaces, triangles, convex polygons, rectangles, boxes,
// tetrahedra and convex polyhedra; planes, triangles, convex polygons and rectangles with each other and all of these; in
// either order.  The plane's: query/section/intersection2.hpp.  Plane with plane, and three planes:
// query/section/planes.hpp.
// Laws: (1) the set of points that both closed sets have in common, in real arithmetic, told as
// query/section/intersection_result.hpp says.  (2) Swapping the figures, naming their corners in another order and powers of
// two change nothing; permuting coordinates or translating (where nothing is rounded) moves the set.  (3) Degenerate
// figures are the sets they are: a flat triangle, box or tetrahedron, a line of zero direction, a plane of zero normal
// (all of space, or nothing), a plane of three points on one line (that line).  (4) Corners are held as points as given
// or as LinePlanePoint3; as rational points where a plane is given by its normal, a box is oriented, a rectangle is one of
// the figures, or no doubles hold the point + direction of a line or ray.
// A polygon that is not planar or not convex throws InvalidShape, NaN and infinity NonFinite, by name.
// Source: RTCD 5.2.9, 5.2.10, 5.3.1, 5.3.3, 5.3.4, 5.3.6, 5.3.8; docs/intersection.md.
// Cost: 12 to 50 ns for segments and triangles in general position and where a plane is missed; else microseconds, tens
// where exact integers decide.  Bounded by n^2 operations for n corners of both, on integers as long as the exponents'
// span.
#pragma once

#include "plumb/query/section/intersection2.hpp"

namespace plumb {

Intersection3 intersection(const Segment3& a, const Triangle3& b);
Intersection3 intersection(const Triangle3& a, const Triangle3& b);
Intersection3 intersection(const Triangle3& a, const Aabb3& b);
template <class A, class B>
requires query::SectionPair<A, B, 3> Intersection3 intersection(const A& a, const B& b) {
  if (query::are_parted_by_signs(a, b)) return {};
  return query::common_set3(query::view_of(a), query::view_of(b));
}

}  // namespace plumb
