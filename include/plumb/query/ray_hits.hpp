// Does a ray, a segment or a line hit a triangle, a ball or an axis-aligned box?  Yes or no, at the speed of doubles.
//
// Laws: (1) the answer of real arithmetic on closed sets, for all finite doubles: that of first_hit (query/ray.hpp).
// (2) By HitRule::half_open a triangle is hit where the ray hits it that is moved by a vector (x, y, z) with
// 1 >> x >> y >> z > 0, the same for all triangles; so any set of triangles is answered as one true ray answers.  Of
// two triangles with a common edge, or of a fan about a vertex, on both sides of the ray exactly one is hit; triangles
// parallel to the ray are not.  A closed mesh is hit an odd number of times from a point inside, an even number from
// outside; and of two segments end to end exactly one hits what their common end lies on.
// A negative radius throws InvalidShape, NaN and infinity NonFinite, by name.
// Source: RTCD 5.3.2, 5.3.3 (figure 5.23), 5.3.6; the moved ray is simulation of simplicity with one vector for the
// whole scene.  Cost: about one and a half times the plain test where doubles decide; microseconds where not.
#pragma once

#include "plumb/query/ray.hpp"

namespace plumb {

bool hits(const Ray3& ray, const Triangle3& triangle, HitRule rule = HitRule::closed);
bool hits(const Segment3& segment, const Triangle3& triangle, HitRule rule = HitRule::closed);
bool hits(const Line3& line, const Triangle3& triangle, HitRule rule = HitRule::closed);

bool hits(const Ray3& ray, const Sphere3& sphere);
bool hits(const Segment3& segment, const Sphere3& sphere);
bool hits(const Line3& line, const Sphere3& sphere);

bool hits(const Ray3& ray, const Aabb3& box);
bool hits(const Segment3& segment, const Aabb3& box);
bool hits(const Line3& line, const Aabb3& box);

}  // namespace plumb
