// Narrow phase: do two figures of the plane meet, and do they overlap or only touch?  Lines, rays, segments, triangles,
// boxes.
//
// Laws: (1) the answer of real arithmetic, for all finite doubles (figure/basic/relation.hpp says what touching is).
// (2) relate is symmetric, and the same for every order of corners and ends.  (3) intersects is relate != disjoint.
// (4) What is degenerate is the set it is: a triangle may be a segment or a point, a ray of zero direction is its
// origin, a box flat, a point, or empty.  Declared once for each pair; query/overlap/overlap.hpp swaps the arguments.
// NaN and infinities throw NonFinite, naming the part.
// Source: RTCD 5.1.9.1, 5.2.1, 5.2.10, 5.3.3.
// Cost: 5 to 15 ns for segments and triangles where doubles decide; signs of degree 2: some eight for a triangle and a
// box.
#pragma once

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb {

Relation relate(const Line2& a, const Line2& b, Asked asked = {});
Relation relate(const Line2& a, const Ray2& b, Asked asked = {});
Relation relate(const Line2& a, const Segment2& b, Asked asked = {});
Relation relate(const Line2& a, const Triangle2& b, Asked asked = {});
Relation relate(const Line2& a, const Aabb2& b, Asked asked = {});
Relation relate(const Ray2& a, const Ray2& b, Asked asked = {});
Relation relate(const Ray2& a, const Segment2& b, Asked asked = {});
Relation relate(const Ray2& a, const Triangle2& b, Asked asked = {});
Relation relate(const Ray2& a, const Aabb2& b, Asked asked = {});
Relation relate(const Segment2& a, const Segment2& b, Asked asked = {});
Relation relate(const Segment2& a, const Triangle2& b, Asked asked = {});
Relation relate(const Segment2& a, const Aabb2& b, Asked asked = {});
Relation relate(const Triangle2& a, const Triangle2& b, Asked asked = {});
Relation relate(const Triangle2& a, const Aabb2& b, Asked asked = {});

}  // namespace plumb
