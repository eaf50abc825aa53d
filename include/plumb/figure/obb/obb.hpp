// Bounding volume (OBB), separating axes: do two oriented boxes meet?  And what else is asked of them: corners, volume,
// a box around both, their image.
//
// A box is the parallelepiped that its numbers say (figure/basic/box.hpp): its axes need be neither orthonormal nor
// independent, and it may be flat, a segment or a point.
// Laws: (1) relate is exact for all boxes, and so symmetric.  (2) What is made of points, boxes or images contains them
// exactly: half extents are rounded outward.  (3) Corners, volume and surface area are the exact ones, rounded once,
// volume and surface area infinite beyond all doubles.
// A coordinate that is NaN or infinite throws NonFinite; a box that doubles cannot hold throws BeyondDoubles.
// Source: RTCD 4.4, 4.4.1, 4.4.2, 6.5.3.
// Cost: relate about 20 ns where doubles decide, in the plane 10; a few microseconds where boxes touch or are
// degenerate.  Bounded by a fixed number of operations (n is eight corners), on integers as long as the exponents'
// span.
#pragma once

#include <array>
#include <span>

#include "plumb/arith/rounding.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/pose_view.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

/// By the fifteen axes; what lies in a plane or on a line is compared there.
Relation relate(const Obb3& a, const Obb3& b);
/// By the four axes.
Relation relate(const Obb2& a, const Obb2& b);

bool intersects(const Obb3& a, const Obb3& b);
bool intersects(const Obb2& a, const Obb2& b);

/// Corner i is center + sum of s_k half_k axes_k with s_k = 1 where bit k of i is set, else -1.
std::array<Point3, 8> corners(const Obb3& box);
std::array<Point2, 4> corners(const Obb2& box);

/// Around points, with these axes, of any lengths and angles: half extents are the least that contain all points around
/// the center, rounded up.  Throws InvalidShape for no points and for dependent axes.
Obb3 fit_obb(const std::array<Vector3, 3>& axes, std::span<const Point3> points);
Obb2 fit_obb(const std::array<Vector2, 2>& axes, std::span<const Point2> points);

/// Around a box; throws InvalidShape for an empty one.
Obb2 oriented_box(const Aabb2& box);
Obb3 oriented_box(const Aabb3& box);

/// Around both: of boxes with the axes of one, of the other, and with axes halfway between, the one of least volume, in
/// the plane of least area.  Where a box lies in the other, that one.
Obb2 merge(const Obb2& a, const Obb2& b);
Obb3 merge(const Obb3& a, const Obb3& b);

/// Around the image of the box.  Its axes are the images of the box's, where these are doubles the image itself.
Obb2 transform(const Obb2& box, PoseView2 pose);
Obb3 transform(const Obb3& box, PoseView pose);

double volume(const Obb3& box);
double surface_area(const Obb3& box);

}  // namespace plumb
