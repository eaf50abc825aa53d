// Bounding volume (AABB): which axis-aligned box holds it?  Of points, of shapes, of two boxes, of what moves.
//
// Laws: (1) a box certainly contains what it was made for; (2) it is the smallest box of doubles that does: each bound
// is the exact one, rounded outward once (those of ellipsoids, cylinders and cones in three steps).  (3) merge is commutative,
// associative and idempotent as sets, and an empty box changes nothing.  (4) The transform of a box is the box of its
// exact image; an empty box stays as it is.
// No points throw InvalidShape, as does a negative radius; NaN and infinities throw NonFinite; a bound that no double
// holds throws BeyondDoubles.
// Source: RTCD 4.2, 4.2.2, 4.2.3, 4.2.4, 4.2.6, 6.5.1.
// Cost: points by plain comparisons; a bound that needs rounding some 20 ns.  Nothing is searched: a span is passed
// through once.
#pragma once

#include <concepts>
#include <span>

#include "plumb/arith/error.hpp"
#include "plumb/arith/rounding.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/pose_view.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb {

namespace figure::box {

/// The number; throws BeyondDoubles for an infinity.
double require_bound(double bound);

}  // namespace figure::box

/// The box of the points.
Aabb2 fit_aabb(std::span<const Point2> points);
Aabb3 fit_aabb(std::span<const Point3> points);

/// The box of the points under the pose: the points are kept where they are, and looked at again each time (RTCD
/// 4.2.4).  Six comparisons a point.
Aabb3 fit_aabb(std::span<const Point3> points, PoseView pose);

Aabb2 fit_aabb(const Segment2& shape);
Aabb3 fit_aabb(const Segment3& shape);
Aabb2 fit_aabb(const Triangle2& shape);
Aabb3 fit_aabb(const Triangle3& shape);
Aabb3 fit_aabb(const Tetrahedron3& shape);
Aabb2 fit_aabb(const Quadrilateral2& shape);
Aabb3 fit_aabb(const Quadrilateral3& shape);
Aabb2 fit_aabb(const Polygon2& shape);
Aabb3 fit_aabb(const Polygon3& shape);
Aabb2 fit_aabb(const HoledPolygon2& shape);
Aabb3 fit_aabb(const HoledPolygon3& shape);
Aabb3 fit_aabb(const ConvexPolyhedron3& shape);

/// With the bounding sphere of an object that turns about the sphere's center: a box that need not turn (RTCD 4.2.3).
Aabb2 fit_aabb(const Circle2& shape);
Aabb3 fit_aabb(const Sphere3& shape);
Aabb2 fit_aabb(const Capsule2& shape);
Aabb3 fit_aabb(const Capsule3& shape);
Aabb3 fit_aabb(const Lozenge3& shape);
Aabb2 fit_aabb(const Obb2& shape);
Aabb3 fit_aabb(const Obb3& shape);
Aabb3 fit_aabb(const Rectangle3& shape);
Aabb3 fit_aabb(const Ellipsoid3& shape);
Aabb3 fit_aabb(const Cylinder3& shape);
Aabb3 fit_aabb(const Cone3& shape);

/// Of any shape whose reach is told along a direction, and of yours.
template <Described Shape>
requires requires(const Shape& s) {
  { support_value(s, Vector3{}, Rounding::up) } -> std::same_as<double>;
}
Aabb3 fit_aabb(const Shape& shape) {
  const auto reach = [&shape](double x, double y, double z) {
    return figure::box::require_bound(support_value(shape, Vector3{x, y, z}, Rounding::up));
  };
  return {{0 - reach(-1, 0, 0), 0 - reach(0, -1, 0), 0 - reach(0, 0, -1)},  // never -0
          {reach(1, 0, 0), reach(0, 1, 0), reach(0, 0, 1)}};
}

/// The box of both.
Aabb2 merge(const Aabb2& a, const Aabb2& b);
Aabb3 merge(const Aabb3& a, const Aabb3& b);

/// The box of the image.
Aabb2 transform(const Aabb2& box, PoseView2 pose);
Aabb3 transform(const Aabb3& box, PoseView pose);

/// The box with every face moved outward by the margin, which may be negative: then a box that is too small for it
/// becomes empty.
Aabb2 expand(const Aabb2& box, double margin);
Aabb3 expand(const Aabb3& box, double margin);

}  // namespace plumb
