// Of which type is this figure?  What a view of it forgot.
//
// Cost: a jump.  Nothing is searched.
#pragma once

#include "plumb/query/body/pairs.hpp"

namespace plumb::query {

// Each kind with its type of the plane and of space, the same where it has but one.
#define PLUMB_EACH_KIND(CASE)                                                  \
  CASE(point, Point2, Point3)                                                  \
  CASE(line, Line2, Line3)                                                     \
  CASE(ray, Ray2, Ray3)                                                        \
  CASE(segment, Segment2, Segment3)                                            \
  CASE(plane, Plane3, Plane3)                                                  \
  CASE(three_point_plane, ThreePointPlane3, ThreePointPlane3)                  \
  CASE(halfspace, Halfspace2, Halfspace3)                                      \
  CASE(triangle, Triangle2, Triangle3)                                         \
  CASE(quadrilateral, Quadrilateral2, Quadrilateral3)                          \
  CASE(polygon, Polygon2, Polygon3)                                            \
  CASE(holed_polygon, HoledPolygon2, HoledPolygon3)                            \
  CASE(rectangle, Rectangle3, Rectangle3)                                      \
  CASE(tetrahedron, Tetrahedron3, Tetrahedron3)                                \
  CASE(ball, Circle2, Sphere3)                                                 \
  CASE(aabb, Aabb2, Aabb3)                                                     \
  CASE(obb, Obb2, Obb3)                                                        \
  CASE(capsule, Capsule2, Capsule3)                                            \
  CASE(lozenge, Lozenge3, Lozenge3)                                            \
  CASE(cylinder, Cylinder3, Cylinder3)                                         \
  CASE(cone, Cone3, Cone3)                                                     \
  CASE(k_dop, KDop2, KDop3)                                                    \
  CASE(halfspace_intersection, HalfspaceIntersection2, HalfspaceIntersection3) \
  CASE(spherical_cap, SphericalCap3, SphericalCap3)                            \
  CASE(convex_polyhedron, ConvexPolyhedron3, ConvexPolyhedron3)

/// Calls f with a null pointer to its type.
template <class F>
decltype(auto) with_figure_type(const FigureView& v, const F& f) {
#define PLUMB_CASE(kind, shape2, shape3) \
  case FigureKind::kind:                 \
    return v.dimension == 2 ? f(static_cast<const shape2*>(nullptr)) : f(static_cast<const shape3*>(nullptr));
  switch (v.kind) { PLUMB_EACH_KIND(PLUMB_CASE) }
#undef PLUMB_CASE
  // No kind is left.  Behind what compilers are told cannot be reached they put a part of no length, at whose place nobody
  // who unwinds a stack finds the function that stands there.
  return f(static_cast<const ConvexPolyhedron3*>(nullptr));
}

/// The same of a figure of a dimension that is known, where f takes its type; for any other nothing is compiled, and
/// `otherwise` is called.
template <int Dimension, class F, class Otherwise>
auto with_figure_type_if(const FigureView& v, const F& f, const Otherwise& otherwise) {
#define PLUMB_CASE(kind, shape2, shape3)                                                                             \
  case FigureKind::kind: {                                                                                           \
    using Shape = std::conditional_t<Dimension == 2, shape2, shape3>;                                                \
    if constexpr (requires { f(static_cast<const Shape*>(nullptr)); }) return f(static_cast<const Shape*>(nullptr)); \
    break;                                                                                                           \
  }
  switch (v.kind) { PLUMB_EACH_KIND(PLUMB_CASE) }
#undef PLUMB_CASE
  return otherwise();
}
#undef PLUMB_EACH_KIND

/// Calls f with the figure as it was.
template <class F>
decltype(auto) with_figure(const FigureView& v, const F& f) {
  return with_figure_type(
      v, [&]<class Shape>(const Shape*) -> decltype(auto) { return f(*static_cast<const Shape*>(v.shape)); });
}

}  // namespace plumb::query
