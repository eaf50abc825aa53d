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

template <query::StraightRay3 Ray>
bool hits(const Ray& ray, const Triangle3& triangle, HitRule rule = HitRule::closed) {
  if (rule == HitRule::half_open) return query::hits_half_open(ray, triangle);
  return query::relate_as(query::Question::hits, ray, triangle) != Relation::disjoint;
}
template <query::StraightRay3 Ray>
bool hits(const Ray& ray, const Sphere3& sphere) {
  return query::relate_as(query::Question::hits, ray, sphere) != Relation::disjoint;
}
template <query::StraightRay3 Ray>
bool hits(const Ray& ray, const Aabb3& box) {
  return query::relate_as(query::Question::hits, ray, box) != Relation::disjoint;
}

/// Of what is known at run time alone.
bool hits(const AnyRay& ray, const Triangle3& triangle, HitRule rule = HitRule::closed);
bool hits(const AnyRay& ray, const Sphere3& sphere);
bool hits(const AnyRay& ray, const Aabb3& box);

/// As first_hit decides.
template <query::SeenInSpace Shape>
bool hits(const AnyRay& ray, const Shape& shape) {
  return query::RayAnswers<Shape>::hits(ray, shape);
}
template <query::SeenInPlane Shape>
bool hits(const AnyRay2& ray, const Shape& shape) {
  return query::RayAnswers2<Shape>::hits(ray, shape);
}

}  // namespace plumb
