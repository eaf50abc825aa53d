// Narrow phase, separating axes: does a box in space meet what is straight, a triangle, or a box of the other kind, and
// do they overlap or only touch?
//
// Laws: (1) the answer of real arithmetic, for all finite doubles (figure/basic/relation.hpp says what touching is).
// (2) An oriented box is the parallelepiped of its axes, orthonormal or not (figure/basic/box.hpp).  (3) relate is symmetric;
// intersects is relate != disjoint.  (4) Boxes may be flat, segments or points, axis-aligned ones empty; triangles,
// rays and lines degenerate.  Declared once for each pair; query/overlap/overlap.hpp swaps the arguments.
// NaN and infinities throw NonFinite, naming the part.
// Source: Akenine-Moller 2001; RTCD 5.2.1, 5.2.9, 5.3.3.
// Cost: some 10 to 30 ns where doubles decide.
#pragma once

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb {

Relation relate(const Line3& a, const Aabb3& b, Asked asked = {});
Relation relate(const Ray3& a, const Aabb3& b, Asked asked = {});
Relation relate(const Segment3& a, const Aabb3& b, Asked asked = {});
Relation relate(const Triangle3& a, const Aabb3& b, Asked asked = {});
Relation relate(const Line3& a, const Obb3& b, Asked asked = {});
Relation relate(const Ray3& a, const Obb3& b, Asked asked = {});
Relation relate(const Segment3& a, const Obb3& b, Asked asked = {});
Relation relate(const Triangle3& a, const Obb3& b, Asked asked = {});
Relation relate(const Aabb3& a, const Obb3& b, Asked asked = {});

}  // namespace plumb
