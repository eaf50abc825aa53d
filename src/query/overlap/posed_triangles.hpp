// Does a triangle under a pose, whose corners are not rounded, meet another, or a shape?  Do two overlap or only touch?
//
// Laws: those of relate and intersects (query/overlap/overlap.hpp), of the exact images; the poses may differ, be
// singular, and lead beyond the largest double; shapes may be flat or empty.
// Source: Guigue and Devillers 2003; RTCD 5.2.7, 5.2.9, 5.2.10.
// Cost: some 300 ns of triangles, below a microsecond of shapes, where doubles decide; microseconds, tens where they do
// not; what has many halfspaces, and flat boxes, by linear programs, some 100.
#pragma once

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/round.hpp"
#include "query/body/posed_corners.hpp"

namespace plumb::query {

/// Of finite numbers; radii are not negative.
Relation relate(const PosedTriangle3& a, const PosedTriangle3& b);
bool intersects(const PosedTriangle3& triangle, const Aabb3& box);
bool intersects(const PosedTriangle3& triangle, const Obb3& box);
bool intersects(const PosedTriangle3& triangle, const Sphere3& ball);
bool intersects(const PosedTriangle3& triangle, const Capsule3& capsule);
bool intersects(const PosedTriangle3& triangle, const Segment3& segment);
bool intersects(const PosedTriangle3& triangle, const Halfspace3& halfspace);
bool intersects(const PosedTriangle3& triangle, const HalfspaceIntersection3& region);

}  // namespace plumb::query
