// Narrow phase: do a cylinder or a cone and a line, a ray, a segment, a plane or a halfspace meet, and do they overlap
// or only touch?
//
// The shapes are those of figure/basic/round.hpp: flat ends, and a ball where the ends of the axis are equal.
// Laws: (1) the answer of real arithmetic, for all finite doubles: along a line the surface is a quadratic whose least
// value between the ends has a rational place, and a plane is compared with the square of what a disk reaches, so that
// no root is taken.  (2) With radius zero the shape is its axis; lines of zero direction are points, a normal of zero
// says all of space or nothing, three points that span no plane are their line or their place.
// A negative radius throws InvalidShape; NaN and infinities throw NonFinite, naming the part.
// Source: RTCD 5.2.4, 5.3.7.
// Cost: some 50 ns; about a microsecond in integers where shapes touch or all but do.
#pragma once

#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/round.hpp"

namespace plumb {

/// Inside, where there is an inside, is overlapping.
Relation relate(const Point3& a, const Cylinder3& b, Asked asked = {});
Relation relate(const Point3& a, const Cone3& b, Asked asked = {});

Relation relate(const Line3& a, const Cylinder3& b, Asked asked = {});
Relation relate(const Ray3& a, const Cylinder3& b, Asked asked = {});
Relation relate(const Segment3& a, const Cylinder3& b, Asked asked = {});
Relation relate(const Plane3& a, const Cylinder3& b, Asked asked = {});
Relation relate(const ThreePointPlane3& a, const Cylinder3& b, Asked asked = {});
Relation relate(const Halfspace3& a, const Cylinder3& b, Asked asked = {});

Relation relate(const Line3& a, const Cone3& b, Asked asked = {});
Relation relate(const Ray3& a, const Cone3& b, Asked asked = {});
Relation relate(const Segment3& a, const Cone3& b, Asked asked = {});
Relation relate(const Plane3& a, const Cone3& b, Asked asked = {});
Relation relate(const ThreePointPlane3& a, const Cone3& b, Asked asked = {});
Relation relate(const Halfspace3& a, const Cone3& b, Asked asked = {});

}  // namespace plumb
