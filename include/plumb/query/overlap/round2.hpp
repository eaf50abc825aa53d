// Narrow phase: do a disk or a capsule of the plane and another figure of it meet, and do they overlap or only touch?
//
// Laws: those of query/overlap/round.hpp.  The answer is that of the same figures in space, where distances are the
// same; what has an inside in the plane has it relative to its affine hull there.
// Source: RTCD 4.3, 4.5.1, 5.2.5, 5.2.8, 5.3.2.
// Cost: that of query/overlap/round.hpp.
#pragma once

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"

namespace plumb {

Relation relate(const Point2& a, const Circle2& b, Asked asked = {});
Relation relate(const Line2& a, const Circle2& b, Asked asked = {});
Relation relate(const Ray2& a, const Circle2& b, Asked asked = {});
Relation relate(const Segment2& a, const Circle2& b, Asked asked = {});
Relation relate(const Halfspace2& a, const Circle2& b, Asked asked = {});
Relation relate(const Triangle2& a, const Circle2& b, Asked asked = {});
Relation relate(const Quadrilateral2& a, const Circle2& b, Asked asked = {});
Relation relate(const Polygon2& a, const Circle2& b, Asked asked = {});
Relation relate(const HoledPolygon2& a, const Circle2& b, Asked asked = {});
Relation relate(const Circle2& a, const Aabb2& b, Asked asked = {});
Relation relate(const Circle2& a, const Obb2& b, Asked asked = {});
Relation relate(const Circle2& a, const Capsule2& b, Asked asked = {});
Relation relate(const Circle2& a, const KDop2& b, Asked asked = {});
Relation relate(const Circle2& a, const HalfspaceIntersection2& b, Asked asked = {});

Relation relate(const Point2& a, const Capsule2& b, Asked asked = {});
Relation relate(const Line2& a, const Capsule2& b, Asked asked = {});
Relation relate(const Ray2& a, const Capsule2& b, Asked asked = {});
Relation relate(const Segment2& a, const Capsule2& b, Asked asked = {});
Relation relate(const Halfspace2& a, const Capsule2& b, Asked asked = {});
Relation relate(const Triangle2& a, const Capsule2& b, Asked asked = {});
Relation relate(const Quadrilateral2& a, const Capsule2& b, Asked asked = {});
Relation relate(const Polygon2& a, const Capsule2& b, Asked asked = {});
Relation relate(const HoledPolygon2& a, const Capsule2& b, Asked asked = {});
Relation relate(const Aabb2& a, const Capsule2& b, Asked asked = {});
Relation relate(const Obb2& a, const Capsule2& b, Asked asked = {});
Relation relate(const Capsule2& a, const KDop2& b, Asked asked = {});
Relation relate(const Capsule2& a, const HalfspaceIntersection2& b, Asked asked = {});

}  // namespace plumb
