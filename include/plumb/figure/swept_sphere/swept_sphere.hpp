// Bounding volume (capsule, lozenge): swept spheres as bounds: how do two lie to one another, and which one holds these
// points?
//
// A core, a segment or a parallelogram, and all that is near to it.
// Laws: (1) relate and intersects are exact and symmetric: the distance of the cores against the sum of the radii,
// whatever is parallel, flat or a point.  (2) What is fitted, merged or transformed certainly contains what it was made
// of: ends and edges are guesses in doubles, the radius is the least double that then holds all, of merged and
// transformed ones within some ulps; of several guesses the one of least volume, as doubles measure it.  (3) A capsule or lozenge that holds the other is what merging gives; of
// cylinders only one that equals the other.
// A fit is by principal axes, tight for elongated and flat sets; it is not the smallest: around two hundred points of a
// capsule's or a lozenge's surface it has up to twice that volume.  One point, and points that
// are all equal, give a radius of zero.
// No points and a negative radius throw InvalidShape; NaN and infinities throw NonFinite; a bound that no double holds
// throws BeyondDoubles.
// Source: RTCD 4.5, 4.5.1; Larsen and others 1999 for lozenges.
// Cost: relate of capsules some 25 ns and of lozenges some 150 ns where a plane between them or two points near to one
// another prove the answer; exact integers where shapes touch, up to a millisecond.  A fit some 100 ns a point.
// Bounded by n operations a fit and a fixed number a relation, on integers as long as the exponents' span.
#pragma once

#include <span>

#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/pose_view.hpp"
#include "plumb/figure/basic/relation.hpp"
#include "plumb/figure/basic/round.hpp"

namespace plumb {

Relation relate(const Capsule2& a, const Capsule2& b);
Relation relate(const Capsule3& a, const Capsule3& b);
Relation relate(const Lozenge3& a, const Lozenge3& b);
bool intersects(const Capsule2& a, const Capsule2& b);
bool intersects(const Capsule3& a, const Capsule3& b);
bool intersects(const Lozenge3& a, const Lozenge3& b);

/// False: the cylinders are disjoint for certain, for the capsules around them are, or a plane at an end of one parts
/// them.  True: nothing is known.
bool may_overlap(const Cylinder3& a, const Cylinder3& b);

/// Does the outer one hold every point of the inner one?
bool contains(const Capsule3& outer, const Capsule3& inner);
bool contains(const Lozenge3& outer, const Lozenge3& inner);

/// Around the points: along their principal axis, in the plane of their two principal axes.
Capsule2 fit_capsule(std::span<const Point2> points);
Capsule3 fit_capsule(std::span<const Point3> points);
Lozenge3 fit_lozenge(std::span<const Point3> points);
Cylinder3 fit_cylinder(std::span<const Point3> points);

/// Around both.
Capsule2 merge(const Capsule2& a, const Capsule2& b);
Capsule3 merge(const Capsule3& a, const Capsule3& b);
Lozenge3 merge(const Lozenge3& a, const Lozenge3& b);
/// Along the axis of one of them or the line of their middles, whichever takes less room.
Cylinder3 merge(const Cylinder3& a, const Cylinder3& b);

/// Around the image: the image of the core, its ends rounded, and the radius times the largest stretch of the matrix,
/// under a rigid pose the radius itself, and what the ends are off.
Capsule2 transform(const Capsule2& capsule, PoseView2 pose);
Capsule3 transform(const Capsule3& capsule, PoseView pose);
Lozenge3 transform(const Lozenge3& lozenge, PoseView pose);
/// Around the image: along the image of the axis, as long as the image of the ends asks for.
Cylinder3 transform(const Cylinder3& cylinder, PoseView pose);

}  // namespace plumb
