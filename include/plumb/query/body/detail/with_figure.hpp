// Of which type is this figure?  What a view of it forgot.
//
// Cost: a jump.  Nothing is searched.
#pragma once

#include "plumb/query/body/pairs.hpp"

namespace plumb::query {

/// Calls f with a null pointer to its type.
template <class F>
decltype(auto) with_figure_type(const FigureView& v, const F& f) {
#define PLUMB_CASE(kind, shape2, shape3) \
  case FigureKind::kind:                 \
    return v.dimension == 2 ? f(static_cast<const shape2*>(nullptr)) : f(static_cast<const shape3*>(nullptr));
  switch (v.kind) {
    PLUMB_CASE(point, Point2, Point3)
    PLUMB_CASE(line, Line2, Line3)
    PLUMB_CASE(ray, Ray2, Ray3)
    PLUMB_CASE(segment, Segment2, Segment3)
    PLUMB_CASE(plane, Plane3, Plane3)
    PLUMB_CASE(three_point_plane, ThreePointPlane3, ThreePointPlane3)
    PLUMB_CASE(halfspace, Halfspace2, Halfspace3)
    PLUMB_CASE(triangle, Triangle2, Triangle3)
    PLUMB_CASE(quadrilateral, Quadrilateral2, Quadrilateral3)
    PLUMB_CASE(polygon, Polygon2, Polygon3)
    PLUMB_CASE(holed_polygon, HoledPolygon2, HoledPolygon3)
    PLUMB_CASE(rectangle, Rectangle3, Rectangle3)
    PLUMB_CASE(tetrahedron, Tetrahedron3, Tetrahedron3)
    PLUMB_CASE(ball, Circle2, Sphere3)
    PLUMB_CASE(aabb, Aabb2, Aabb3)
    PLUMB_CASE(obb, Obb2, Obb3)
    PLUMB_CASE(capsule, Capsule2, Capsule3)
    PLUMB_CASE(lozenge, Lozenge3, Lozenge3)
    PLUMB_CASE(cylinder, Cylinder3, Cylinder3)
    PLUMB_CASE(cone, Cone3, Cone3)
    PLUMB_CASE(k_dop, KDop2, KDop3)
    PLUMB_CASE(halfspace_intersection, HalfspaceIntersection2, HalfspaceIntersection3)
    PLUMB_CASE(spherical_cap, SphericalCap3, SphericalCap3)
    case FigureKind::convex_polyhedron:
    default:
      return f(static_cast<const ConvexPolyhedron3*>(nullptr));
  }
#undef PLUMB_CASE
}

/// Calls f with the figure as it was.
template <class F>
decltype(auto) with_figure(const FigureView& v, const F& f) {
  return with_figure_type(
      v, [&]<class Shape>(const Shape*) -> decltype(auto) { return f(*static_cast<const Shape*>(v.shape)); });
}

}  // namespace plumb::query
