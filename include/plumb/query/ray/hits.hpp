// Ray test, slab test: does a ray, a segment or a line hit a figure?  Yes or no, without the numbers of first_hit, for
// every figure that first_hit takes; of triangles, balls and axis-aligned boxes at the speed of doubles.
//
// Laws: (1) the answer of real arithmetic on closed sets, for all finite doubles: that of first_hit (query/ray/ray.hpp),
// and of intersects (query/overlap/overlap.hpp), by which it is told.
// (2) By HitRule::half_open a triangle is hit where the ray hits it that is moved by a vector (x, y, z) with
// 1 >> x >> y >> z > 0, the same for all triangles; so any set of triangles is answered as one true ray answers.  Of
// two triangles with a common edge, or of a fan about a vertex, on both sides of the ray exactly one is hit; triangles
// parallel to the ray are not.  A closed mesh is hit an odd number of times from a point inside, an even number from
// outside; and of two segments end to end exactly one hits what their common end lies on.
// A negative radius throws InvalidShape, NaN and infinity NonFinite, by name.
// Source: RTCD 5.3.2, 5.3.3 (figure 5.23), 5.3.6; the moved ray is simulation of simplicity with one vector for the
// whole scene.
// Cost: that of intersects (docs/overlap.md) for triangles, balls and axis-aligned boxes, else what first_hit takes to
// decide; by the half-open rule microseconds where doubles are in doubt.  Nothing is searched but what relate and
// first_hit search (query/overlap/overlap.hpp, query/ray/ray.hpp).
#pragma once

#include "plumb/query/overlap/overlap.hpp"
#include "plumb/query/ray/ray.hpp"
#include "plumb/query/ray/ray2.hpp"

namespace plumb {

namespace query {

bool hits_half_open(const Ray3& ray, const Triangle3& triangle);
bool hits_half_open(const Segment3& segment, const Triangle3& triangle);
bool hits_half_open(const Line3& line, const Triangle3& triangle);

}  // namespace query

inline bool hits(const Ray3& ray, const Triangle3& triangle, HitRule rule = HitRule::closed) {
  return rule == HitRule::closed ? query::relate_as(query::Question::hits, ray, triangle) != Relation::disjoint
                                 : query::hits_half_open(ray, triangle);
}
inline bool hits(const Segment3& segment, const Triangle3& triangle, HitRule rule = HitRule::closed) {
  return rule == HitRule::closed ? query::relate_as(query::Question::hits, segment, triangle) != Relation::disjoint
                                 : query::hits_half_open(segment, triangle);
}
inline bool hits(const Line3& line, const Triangle3& triangle, HitRule rule = HitRule::closed) {
  return rule == HitRule::closed ? query::relate_as(query::Question::hits, line, triangle) != Relation::disjoint
                                 : query::hits_half_open(line, triangle);
}

inline bool hits(const Ray3& ray, const Sphere3& sphere) {
  return query::relate_as(query::Question::hits, ray, sphere) != Relation::disjoint;
}
inline bool hits(const Segment3& segment, const Sphere3& sphere) {
  return query::relate_as(query::Question::hits, segment, sphere) != Relation::disjoint;
}
inline bool hits(const Line3& line, const Sphere3& sphere) {
  return query::relate_as(query::Question::hits, line, sphere) != Relation::disjoint;
}

inline bool hits(const Ray3& ray, const Aabb3& box) {
  return query::relate_as(query::Question::hits, ray, box) != Relation::disjoint;
}
inline bool hits(const Segment3& segment, const Aabb3& box) {
  return query::relate_as(query::Question::hits, segment, box) != Relation::disjoint;
}
inline bool hits(const Line3& line, const Aabb3& box) {
  return query::relate_as(query::Question::hits, line, box) != Relation::disjoint;
}

/// Of what is known at run time alone.
bool hits(const AnyRay& ray, const Triangle3& triangle, HitRule rule = HitRule::closed);
bool hits(const AnyRay& ray, const Sphere3& sphere);
bool hits(const AnyRay& ray, const Aabb3& box);

/// As first_hit decides.
bool hits(const AnyRay& ray, const Plane3& plane);
bool hits(const AnyRay& ray, const ThreePointPlane3& plane);
bool hits(const AnyRay& ray, const Halfspace3& halfspace);
bool hits(const AnyRay& ray, const Quadrilateral3& quadrilateral);
bool hits(const AnyRay& ray, const Polygon3& polygon);
bool hits(const AnyRay& ray, const HoledPolygon3& polygon);
bool hits(const AnyRay& ray, const Rectangle3& rectangle);
bool hits(const AnyRay& ray, const Tetrahedron3& tetrahedron);
bool hits(const AnyRay& ray, const Capsule3& capsule);
bool hits(const AnyRay& ray, const Cylinder3& cylinder);
bool hits(const AnyRay& ray, const Cone3& cone);
bool hits(const AnyRay& ray, const Lozenge3& lozenge);
bool hits(const AnyRay& ray, const Ellipsoid3& ellipsoid);
bool hits(const AnyRay& ray, const Obb3& box);
bool hits(const AnyRay& ray, const KDop3& k_dop);
bool hits(const AnyRay& ray, const ConvexPolyhedron3& polyhedron);

bool hits(const AnyRay2& ray, const Segment2& segment);
bool hits(const AnyRay2& ray, const Triangle2& triangle);
bool hits(const AnyRay2& ray, const Quadrilateral2& quadrilateral);
bool hits(const AnyRay2& ray, const Polygon2& polygon);
bool hits(const AnyRay2& ray, const HoledPolygon2& polygon);
bool hits(const AnyRay2& ray, const Circle2& circle);
bool hits(const AnyRay2& ray, const Aabb2& box);
bool hits(const AnyRay2& ray, const Obb2& box);
bool hits(const AnyRay2& ray, const Capsule2& capsule);
bool hits(const AnyRay2& ray, const KDop2& k_dop);

}  // namespace plumb
