// Narrow phase: do a ball, a capsule or a lozenge and another figure meet, and do they overlap or only touch?
//
// Each is all points near to its core, a point, a segment or a parallelogram: the answer is the sign of the distance of
// the core and the other figure, minus the radius, or the sum of two, which is not rounded.
// Laws: (1) the answer of real arithmetic, for all finite doubles (figure/basic/relation.hpp says what touching is).
// (2) What is degenerate is the set it is: a capsule of equal ends is a ball, a ball of radius zero a point, a ray of
// zero direction its origin, boxes may be flat, skew or empty, k-DOPs unbounded or empty; a shape of radius zero is
// related as its core is.  (3) Of a polygon that is no more than lines the interior is none, so that a ball can only
// touch it.  (4) Permuting coordinates or corners, and powers of two that lose no bit, change nothing.
// Declared once for each pair, in the order of query/body/pairs.hpp; query/overlap/overlap.hpp swaps the arguments, has intersects,
// and the plane's pairs are in query/overlap/round2.hpp.
// A negative radius throws InvalidShape, as do polygons of fewer than three vertices in a chain or in no plane, and a
// k-DOP of too many or too few ends; NaN and infinities throw NonFinite, naming the part.
// Source: RTCD 4.3, 4.5.1, 5.2.2, 5.2.5, 5.2.6, 5.2.7, 5.2.8, 5.3.2.
// Cost: a ball against a plane, a box with the axes of space or a segment the filter of a formula or two; others some
// 20 to 200 ns for a guess in doubles that is proved; where shapes touch or all but do some 100 us in rationals, for
// k-DOPs up to milliseconds.
#pragma once

#include <array>

#include "plumb/arith/filtered.hpp"
#include "plumb/certify/detail/filter_stage.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/plane.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"
#include "plumb/figure/k_dop/k_dop.hpp"
#include "plumb/figure/sphere/sphere.hpp"
#include "plumb/predicates/plane_distance.hpp"

namespace plumb {

namespace query::round_overlap {

/// For what doubles leave in doubt, and what is no shape.
Relation relate_exactly(const Plane3& a, const Sphere3& b, Asked asked);
Relation relate_exactly(const Halfspace3& a, const Sphere3& b, Asked asked);
Relation relate_exactly(const Sphere3& a, const Aabb3& b, Asked asked);

/// The filter's constant of the square of the distance from a plane against that of the radius, times that of the
/// normal.
extern const double plane_constant;

/// The sign of that, and the side on which the center is; 0 is unsure, as it is for anything but real numbers.
struct PlaneGap {
  int gap, side;
};
inline PlaneGap gap(const Vector3& n, double offset, const Sphere3& ball) {
  const auto& [p, r] = ball;
  using Input = Filtered::Input;
  const std::array<Input, 8> x{{{n.x}, {n.y}, {n.z}, {offset}, {p.x}, {p.y}, {p.z}, {r}}};
  const Filtered height = x[0] * x[4] + x[1] * x[5] + x[2] * x[6] - x[3];
  const Filtered square = predicates::NormalDistanceAgainst3d{}(x);
  const bool sound = !figure::sphere::has_sign(r, r);
  const int gap = sound ? beyond(square.value, plane_constant * square.magnitude) : 0;
  return {gap, beyond(height.value, plane_constant * height.magnitude)};
}

constexpr double clamped(double x, double low, double high) { return x < low ? low : x > high ? high : x; }

}  // namespace query::round_overlap

/// Inside, where there is an inside, is overlapping.
Relation relate(const Point3& a, const Sphere3& b, Asked asked = {});
Relation relate(const Point3& a, const Capsule3& b, Asked asked = {});
Relation relate(const Point3& a, const Lozenge3& b, Asked asked = {});

Relation relate(const Line3& a, const Sphere3& b, Asked asked = {});
Relation relate(const Ray3& a, const Sphere3& b, Asked asked = {});
Relation relate(const Segment3& a, const Sphere3& b, Asked asked = {});
inline Relation relate(const Plane3& a, const Sphere3& b, Asked asked = {}) {
  const auto [gap, side] = query::round_overlap::gap(a.normal, a.offset, b);
  if (gap != 0) [[likely]]
    return gap > 0 ? Relation::disjoint : Relation::overlapping;
  return query::round_overlap::relate_exactly(a, b, asked);
}
Relation relate(const ThreePointPlane3& a, const Sphere3& b, Asked asked = {});
inline Relation relate(const Halfspace3& a, const Sphere3& b, Asked asked = {}) {
  const auto [gap, side] = query::round_overlap::gap(a.normal, a.offset, b);
  if (gap != 0 && (gap < 0 || side != 0)) [[likely]]
    return gap > 0 && side > 0 ? Relation::disjoint : Relation::overlapping;
  return query::round_overlap::relate_exactly(a, b, asked);
}
Relation relate(const Triangle3& a, const Sphere3& b, Asked asked = {});
Relation relate(const Quadrilateral3& a, const Sphere3& b, Asked asked = {});
Relation relate(const Polygon3& a, const Sphere3& b, Asked asked = {});
Relation relate(const HoledPolygon3& a, const Sphere3& b, Asked asked = {});
Relation relate(const Rectangle3& a, const Sphere3& b, Asked asked = {});
Relation relate(const Tetrahedron3& a, const Sphere3& b, Asked asked = {});
/// By the nearest point of the box, whose numbers are input.
inline Relation relate(const Sphere3& a, const Aabb3& b, Asked asked = {}) {
  using query::round_overlap::clamped;
  const auto& [p, q] = b;
  const auto& c = a.center;
  const double all = ((p.x + q.x) + (p.y + q.y)) + (p.z + q.z);
  const Point3 nearest{clamped(c.x, p.x, q.x), clamped(c.y, p.y, q.y), clamped(c.z, p.z, q.z)};
  const auto [gap, sure] = figure::sphere::gap(Sphere3{nearest, 0}, a);
  const bool sound = (p.x <= q.x) & (p.y <= q.y) & (p.z <= q.z) & (all - all == 0);
  if (sure & sound) [[likely]]
    return gap > 0 ? Relation::disjoint : Relation::overlapping;
  return query::round_overlap::relate_exactly(a, b, asked);
}
Relation relate(const Sphere3& a, const Obb3& b, Asked asked = {});
Relation relate(const Sphere3& a, const Capsule3& b, Asked asked = {});
Relation relate(const Sphere3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const Sphere3& a, const KDop3& b, Asked asked = {});
Relation relate(const Sphere3& a, const HalfspaceIntersection3& b, Asked asked = {});
Relation relate(const Sphere3& a, const ConvexPolyhedron3& b, Asked asked = {});

Relation relate(const Line3& a, const Capsule3& b, Asked asked = {});
Relation relate(const Ray3& a, const Capsule3& b, Asked asked = {});
Relation relate(const Segment3& a, const Capsule3& b, Asked asked = {});
Relation relate(const Plane3& a, const Capsule3& b, Asked asked = {});
Relation relate(const ThreePointPlane3& a, const Capsule3& b, Asked asked = {});
Relation relate(const Halfspace3& a, const Capsule3& b, Asked asked = {});
Relation relate(const Triangle3& a, const Capsule3& b, Asked asked = {});
Relation relate(const Quadrilateral3& a, const Capsule3& b, Asked asked = {});
Relation relate(const Polygon3& a, const Capsule3& b, Asked asked = {});
Relation relate(const HoledPolygon3& a, const Capsule3& b, Asked asked = {});
Relation relate(const Rectangle3& a, const Capsule3& b, Asked asked = {});
Relation relate(const Tetrahedron3& a, const Capsule3& b, Asked asked = {});
Relation relate(const Aabb3& a, const Capsule3& b, Asked asked = {});
Relation relate(const Obb3& a, const Capsule3& b, Asked asked = {});
Relation relate(const Capsule3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const Capsule3& a, const KDop3& b, Asked asked = {});
Relation relate(const Capsule3& a, const HalfspaceIntersection3& b, Asked asked = {});
Relation relate(const Capsule3& a, const ConvexPolyhedron3& b, Asked asked = {});

Relation relate(const Line3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const Ray3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const Segment3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const Plane3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const ThreePointPlane3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const Halfspace3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const Triangle3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const Quadrilateral3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const Polygon3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const HoledPolygon3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const Rectangle3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const Tetrahedron3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const Aabb3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const Obb3& a, const Lozenge3& b, Asked asked = {});
Relation relate(const Lozenge3& a, const KDop3& b, Asked asked = {});
Relation relate(const Lozenge3& a, const HalfspaceIntersection3& b, Asked asked = {});
Relation relate(const Lozenge3& a, const ConvexPolyhedron3& b, Asked asked = {});

}  // namespace plumb
