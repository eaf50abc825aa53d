// Do two figures have a point in common, by CGAL's own statements?
//
// Laws: exact for all finite doubles, in either order.  Nothing is answered where CGAL asks for a shape that is not
// degenerate.  CGAL's circles and spheres are their boundaries: for ours a center within the other, or a point of the
// other within the ball, is a meeting as well.
// Source: CGAL's manual, "2D and 3D Linear Geometry Kernel", do_intersect.
// Cost: some 10 us a question.
#pragma once

#include <optional>
#include <variant>

#include "plumb/figure.hpp"

namespace plumb::oracle {

using CgalFigure2 = std::variant<Point2, Line2, Ray2, Segment2, Triangle2, Circle2, Aabb2>;
using CgalFigure3 = std::variant<Point3, Line3, Ray3, Segment3, Plane3, Triangle3, Tetrahedron3, Sphere3, Aabb3>;

std::optional<bool> meet_by_cgal(const CgalFigure2& a, const CgalFigure2& b);
std::optional<bool> meet_by_cgal(const CgalFigure3& a, const CgalFigure3& b);

}  // namespace plumb::oracle
