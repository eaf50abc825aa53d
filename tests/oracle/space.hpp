// What do lines, triangles, planes and boxes in space do to one another, by CGAL's own statements?
//
// Laws: exact for all finite doubles; signs follow our convention.  Nothing is answered where CGAL asks for input that
// is not degenerate.
// Source: CGAL's manual, "2D and 3D Linear Geometry Kernel" and "Linear and Quadratic Programming Solver".
// Cost: 5 us to 1 ms a question.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "plumb/arith/point.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb::oracle {

Sign coplanar_orientation(const Point3& a, const Point3& b, const Point3& c);

/// For coplanar points of which a, b, c are not collinear.
std::optional<Sign> coplanar_orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// Does the line through o in direction d meet the closed triangle?  Nothing when the triangle or d is degenerate, or
/// the line lies in the triangle's plane.
std::optional<bool> line_meets_triangle(const Point3& o, const Vector3& d, const std::array<Point3, 3>& triangle);

/// Sign of t1 - t2 for the points o + t d in two planes of three points each, found as points of intersection; nothing
/// when there is no single such point.
std::optional<Sign> compare_ray_parameters(const Point3& o, const Vector3& d, const std::array<Point3, 3>& first,
                                           const std::array<Point3, 3>& second);

/// Sign of the parameter minus t.
std::optional<Sign> compare_ray_parameter(const Point3& o, const Vector3& d, const std::array<Point3, 3>& plane,
                                          double t);

struct Box {
  Point3 center;
  std::array<Vector3, 3> axes;
  Vector3 half;  // not negative
};

/// Have the two closed boxes a point in common?  By linear programming.
bool boxes_meet(const Box& a, const Box& b);

}  // namespace plumb::oracle
