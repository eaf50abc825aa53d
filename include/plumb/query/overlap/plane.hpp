// Plane test, half-space test: on which sides of a plane does a shape lie, so: does it meet the plane, or the halfspace
// below it?
//
// Laws: (1) the answer of real arithmetic, for all finite doubles (figure/basic/relation.hpp says what touching is): what
// lies in a plane overlaps it, and touches the halfspaces that it bounds.  (2) Multiplying normal and offset by the
// same positive number, where nothing is rounded, changes nothing.  (3) A plane of zero normal is all of space or
// nothing; three points on one line are that line, or a point (figure/basic/plane.hpp).  (4) Shapes may be flat, segments or
// points, axis-aligned boxes empty.  Declared once for each pair; query/overlap/overlap.hpp swaps the arguments.
// NaN and infinities throw NonFinite, naming the part.
// Source: RTCD 5.2.1, 5.2.3, 5.3.1.
// Cost: one to four signs; two for a box, of its corners along the normal.
#pragma once

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb {

Relation relate(const Point3& a, const Plane3& b, Asked asked = {});
Relation relate(const Segment3& a, const Plane3& b, Asked asked = {});
Relation relate(const Plane3& a, const Triangle3& b, Asked asked = {});
Relation relate(const Plane3& a, const Tetrahedron3& b, Asked asked = {});
Relation relate(const Plane3& a, const Aabb3& b, Asked asked = {});
Relation relate(const Plane3& a, const Obb3& b, Asked asked = {});

Relation relate(const Point3& a, const ThreePointPlane3& b, Asked asked = {});
Relation relate(const Segment3& a, const ThreePointPlane3& b, Asked asked = {});
Relation relate(const ThreePointPlane3& a, const Triangle3& b, Asked asked = {});
Relation relate(const ThreePointPlane3& a, const Tetrahedron3& b, Asked asked = {});
Relation relate(const ThreePointPlane3& a, const Aabb3& b, Asked asked = {});
Relation relate(const ThreePointPlane3& a, const Obb3& b, Asked asked = {});

Relation relate(const Point3& a, const Halfspace3& b, Asked asked = {});
Relation relate(const Segment3& a, const Halfspace3& b, Asked asked = {});
Relation relate(const Halfspace3& a, const Triangle3& b, Asked asked = {});
Relation relate(const Halfspace3& a, const Tetrahedron3& b, Asked asked = {});
Relation relate(const Halfspace3& a, const Aabb3& b, Asked asked = {});
Relation relate(const Halfspace3& a, const Obb3& b, Asked asked = {});

}  // namespace plumb
