// Where does a point lie to a shape, by CGAL's own statements?
//
// Laws: exact for all finite doubles.  Nothing is answered where CGAL asks for a shape that is not degenerate.
// Source: CGAL's manual, "2D and 3D Linear Geometry Kernel".
// Cost: some 10 us a question.
#pragma once

#include <array>
#include <optional>

#include "plumb/figure.hpp"

namespace plumb::oracle {

std::optional<Location> locate(const Line2& line, const Point2& p);
std::optional<Location> locate(const Line3& line, const Point3& p);
std::optional<Location> locate(const Ray2& ray, const Point2& p);
std::optional<Location> locate(const Ray3& ray, const Point3& p);
std::optional<Location> locate(const Segment2& segment, const Point2& p);
std::optional<Location> locate(const Segment3& segment, const Point3& p);
std::optional<Location> locate(const Plane3& plane, const Point3& p);
std::optional<Location> locate(const ThreePointPlane3& plane, const Point3& p);
std::optional<Location> locate(const Halfspace2& halfspace, const Point2& p);
std::optional<Location> locate(const Halfspace3& halfspace, const Point3& p);
std::optional<Location> locate(const Triangle2& triangle, const Point2& p);
std::optional<Location> locate(const Triangle3& triangle, const Point3& p);
std::optional<Location> locate(const Tetrahedron3& tetrahedron, const Point3& p);
std::optional<Location> locate(const Circle2& circle, const Point2& p);
std::optional<Location> locate(const Sphere3& sphere, const Point3& p);
std::optional<Location> locate(const Capsule2& capsule, const Point2& p);
std::optional<Location> locate(const Capsule3& capsule, const Point3& p);
std::optional<Location> locate(const Aabb2& box, const Point2& p);
std::optional<Location> locate(const Aabb3& box, const Point3& p);

/// By the affine map that takes the box to a cube.
std::optional<Location> locate(const Obb3& box, const Point3& p);

/// Is the feature's own line or plane as near to p as the triangle is?  As CGAL measures squares of distances in space;
/// in the plane CGAL 5 names another vertex of some triangles, as of (-2, 2), (0, 1), (-1, 0) for (2, 0).
std::optional<bool> is_as_near(const Triangle3& triangle, const Feature& feature, const Point3& p);

/// CGAL's barycenter of the corners: has `told` the nearest doubles to it, where the sum of weights is not zero?
bool is_barycenter(const Triangle2& triangle, const std::array<double, 3>& weights, const Point2& told);
bool is_barycenter(const Triangle3& triangle, const std::array<double, 3>& weights, const Point3& told);

}  // namespace plumb::oracle
