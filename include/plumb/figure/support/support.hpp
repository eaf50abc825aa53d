// Which point of a convex shape lies farthest along a direction?  Support mappings, exact in every choice.
//
//   Support3 s = support_point(capsule, direction);   // s.point, s.feature: 0 for the end a, 1 for b
//
// Laws: (1) the choice of the feature is exact.  (2) `unique` says whether no other point of the shape lies as far; of
//       features that tie, the one of the smallest number is given.  (3) A point that is a vertex of the input is that
//       vertex; any other coordinate is the exact one rounded once to nearest.  (4) Scaling the direction by a positive
//       power of two changes nothing.  (5) A zero direction is allowed: everything ties.
//
// | shape | feature | where a whole face ties, and for a zero direction |
// |---|---|---|
// | points, segment, triangle, quadrilateral, polygon, tetrahedron, polyhedron | index of the vertex | smallest index |
// | boxes, rectangle | bit i: the larger end in axis i | the smaller end |
// | circle, sphere, ellipsoid | 0 | the center, for a zero direction |
// | capsule | 0: end a, 1: end b | a's, or the point a |
// | lozenge | bit i: with edge i | without the edge; for a zero direction the corner |
// | cylinder | 0: end a, 1: end b | a's; the center of the end's disk where that ties |
// | cap | 0: the ball, 1: the circle of the plane | the center, if it is in the cap, else the circle's |
// | cone | 0: apex, 1: rim of the base | apex; the center of the base where that ties |
//
// For a polygon or quadrilateral that is not convex, and for points, the shape is their convex hull.
// Errors: NonFinite by name ("support_point: sphere.radius is nan, ..."); InvalidShape for no points, a negative
// radius, a polygon of fewer than three vertices, a box whose min exceeds its max, an empty cap; BeyondDoubles where a rounded
// coordinate would be infinite.
// Source: RTCD 3.8, 4.2.5 (figure 4.7).
// Cost: a sign of degree 2 for each vertex or axis, and for the numbers of round shapes pairs of doubles, some 100 ns;
// integers where these leave a doubt, some 100 us.  Bounded by n signs, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <span>

#include "plumb/arith/rounding.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/round.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb {

struct Support2 {
  Point2 point;
  std::uint32_t feature;
  bool unique;
  friend bool operator==(const Support2&, const Support2&) = default;
};
struct Support3 {
  Point3 point;
  std::uint32_t feature;
  bool unique;
  friend bool operator==(const Support3&, const Support3&) = default;
};

Support2 support_point(std::span<const Point2> points, const Vector2& direction);
Support2 support_point(const Segment2& segment, const Vector2& direction);
Support2 support_point(const Triangle2& triangle, const Vector2& direction);
Support2 support_point(const Quadrilateral2& quadrilateral, const Vector2& direction);
Support2 support_point(const Polygon2& polygon, const Vector2& direction);
Support2 support_point(const Aabb2& box, const Vector2& direction);
Support2 support_point(const Obb2& box, const Vector2& direction);
Support2 support_point(const Circle2& circle, const Vector2& direction);
Support2 support_point(const Capsule2& capsule, const Vector2& direction);

Support3 support_point(std::span<const Point3> points, const Vector3& direction);
Support3 support_point(const Segment3& segment, const Vector3& direction);
Support3 support_point(const Triangle3& triangle, const Vector3& direction);
Support3 support_point(const Quadrilateral3& quadrilateral, const Vector3& direction);
Support3 support_point(const Polygon3& polygon, const Vector3& direction);
Support3 support_point(const Tetrahedron3& tetrahedron, const Vector3& direction);
Support3 support_point(const Aabb3& box, const Vector3& direction);
Support3 support_point(const AabbWidths3& box, const Vector3& direction);
Support3 support_point(const AabbCenter3& box, const Vector3& direction);
Support3 support_point(const Obb3& box, const Vector3& direction);
Support3 support_point(const Rectangle3& rectangle, const Vector3& direction);
Support3 support_point(const Sphere3& sphere, const Vector3& direction);
Support3 support_point(const Capsule3& capsule, const Vector3& direction);
Support3 support_point(const Lozenge3& lozenge, const Vector3& direction);
Support3 support_point(const Cylinder3& cylinder, const Vector3& direction);
Support3 support_point(const Cone3& cone, const Vector3& direction);
Support3 support_point(const Ellipsoid3& ellipsoid, const Vector3& direction);
Support3 support_point(const SphericalCap3& cap, const Vector3& direction);

/// By climbing from vertex to neighbor, from `start` on; the result is the same for every start.  What ties is walked
/// over, so that neither equal vertices nor coplanar faces end the climb.  Looks at the vertices along the way and at
/// their neighbors: with the last result as the start, a constant number for a direction that has moved little.
Support3 support_point(const ConvexPolyhedron3& polyhedron, const Vector3& direction, std::uint32_t start = 0);

/// direction . x at the support point, rounded once as asked; infinite where that is beyond all doubles and the
/// rounding leads there.  Up gives a halfspace that certainly contains the shape.
double support_value(std::span<const Point2> points, const Vector2& direction, Rounding rounding = Rounding::up);
double support_value(const Aabb2& box, const Vector2& direction, Rounding rounding = Rounding::up);
double support_value(const Obb2& box, const Vector2& direction, Rounding rounding = Rounding::up);
double support_value(const Circle2& circle, const Vector2& direction, Rounding rounding = Rounding::up);
double support_value(const Capsule2& capsule, const Vector2& direction, Rounding rounding = Rounding::up);
double support_value(std::span<const Point3> points, const Vector3& direction, Rounding rounding = Rounding::up);
double support_value(const ConvexPolyhedron3& polyhedron, const Vector3& direction, Rounding rounding = Rounding::up);
double support_value(const AabbWidths3& box, const Vector3& direction, Rounding rounding = Rounding::up);
double support_value(const AabbCenter3& box, const Vector3& direction, Rounding rounding = Rounding::up);
double support_value(const Aabb3& box, const Vector3& direction, Rounding rounding = Rounding::up);
double support_value(const Obb3& box, const Vector3& direction, Rounding rounding = Rounding::up);
double support_value(const Sphere3& sphere, const Vector3& direction, Rounding rounding = Rounding::up);
double support_value(const Capsule3& capsule, const Vector3& direction, Rounding rounding = Rounding::up);
double support_value(const Lozenge3& lozenge, const Vector3& direction, Rounding rounding = Rounding::up);
double support_value(const Cylinder3& cylinder, const Vector3& direction, Rounding rounding = Rounding::up);
double support_value(const Cone3& cone, const Vector3& direction, Rounding rounding = Rounding::up);
double support_value(const Ellipsoid3& ellipsoid, const Vector3& direction, Rounding rounding = Rounding::up);
double support_value(const SphericalCap3& cap, const Vector3& direction, Rounding rounding = Rounding::up);

}  // namespace plumb
