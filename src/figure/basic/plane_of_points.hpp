// Which plane do points lie in, and along which axis may one look at it?
//
// Laws: the spanning points are the first that will do; a projection is along the first of z, x, y that keeps the plane
// a plane, seen as coplanar_orientation sees it.
// Cost: exact signs, linear in the points.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "plumb/certify/direction.hpp"
#include "plumb/predicates.hpp"

namespace plumb {

/// Points a, b, c that span the plane, as far as there are such; the first point that lies off it.
struct PlaneOfPoints {
  int dimension = 0;  // of all points: 0 for a place, 1 for a line, 2 for a plane, 3 for what is in none
  std::array<std::size_t, 3> span{};
  std::size_t off = 0;
};

/// Of points at(0) ... at(count - 1); count is not zero.
template <class At>
PlaneOfPoints plane_of_points(std::size_t count, const At& at) {
  PlaneOfPoints plane;
  for (std::size_t i = 1; i < count; ++i) {
    auto& [a, b, c] = plane.span;
    switch (plane.dimension) {
      case 0:
        if (at(i) != at(a)) b = i, plane.dimension = 1;
        break;
      case 1:
        if (!collinear(at(a), at(b), at(i))) c = i, plane.dimension = 2;
        break;
      default:
        if (orient3d(at(a), at(b), at(c), at(i)) != Sign::zero) {
          plane.dimension = 3;
          plane.off = i;
          return plane;
        }
    }
  }
  return plane;
}

inline PlaneOfPoints plane_of_points(std::span<const Point3> points) {
  return plane_of_points(points.size(), [&](std::size_t i) -> const Point3& { return points[i]; });
}

/// Throws InvalidShape for points of no plane: "locate: the polygon is not planar: its vertex 3 is off the plane ...".
void require_planar(std::string_view function, std::string_view name, const PlaneOfPoints& plane);

enum class Look : unsigned char { along_z, along_x, along_y };

inline Point2 projected(Look look, const Point3& p) {
  return look == Look::along_z ? Point2{p.x, p.y} : look == Look::along_x ? Point2{p.y, p.z} : Point2{p.x, p.z};
}

/// For points that are not on one line.
inline Look look_at_plane(const Point3& a, const Point3& b, const Point3& c) {
  for (const Look look : {Look::along_z, Look::along_x}) {
    if (orient2d(projected(look, a), projected(look, b), projected(look, c)) != Sign::zero) return look;
  }
  return Look::along_y;
}

}  // namespace plumb
