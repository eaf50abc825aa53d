// Narrow phase: does a triangle in space meet what is straight, another triangle, or a tetrahedron, and do they overlap
// or only touch?
//
// Laws: (1) the answer of real arithmetic, for all finite doubles (figure/basic/relation.hpp says what touching is):
// triangles that cross overlap where both insides do, coplanar ones where their insides in the plane do.  (2) relate is
// symmetric, and the same for every order of corners.  (3) intersects is relate != disjoint.  (4) Triangles and
// tetrahedra may be flat, segments or points.  Declared once for each pair; query/overlap/overlap.hpp swaps the arguments.
// NaN and infinities throw NonFinite, naming the part.
// Source: RTCD 5.2.10, 5.3.4, 5.3.6; Guigue and Devillers 2003.
// Cost: some 20 ns for two triangles where doubles decide, 35 for neighbors in a mesh, 80 to 270 for degenerate ones.
#pragma once

#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb {

Relation relate(const Line3& a, const Triangle3& b, Asked asked = {});
Relation relate(const Ray3& a, const Triangle3& b, Asked asked = {});
Relation relate(const Segment3& a, const Triangle3& b, Asked asked = {});
Relation relate(const Triangle3& a, const Triangle3& b, Asked asked = {});
Relation relate(const Segment3& a, const Tetrahedron3& b, Asked asked = {});
Relation relate(const Triangle3& a, const Tetrahedron3& b, Asked asked = {});
Relation relate(const Tetrahedron3& a, const Tetrahedron3& b, Asked asked = {});

/// What is straight, among itself.
Relation relate(const Line3& a, const Line3& b, Asked asked = {});
Relation relate(const Line3& a, const Ray3& b, Asked asked = {});
Relation relate(const Line3& a, const Segment3& b, Asked asked = {});
Relation relate(const Ray3& a, const Ray3& b, Asked asked = {});
Relation relate(const Ray3& a, const Segment3& b, Asked asked = {});
Relation relate(const Segment3& a, const Segment3& b, Asked asked = {});

}  // namespace plumb
