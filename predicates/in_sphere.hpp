// Does a point lie inside the circle of three others, or the sphere of four others?
//
// Laws: swapping two of the points that span the circle (sphere) flips the sign; zero exactly when all points lie on
// one circle or line (sphere or plane); common translation and positive scaling change nothing.
// Source: RTCD 3.1.6.3, 3.1.6.4.  Degree 4 and 5.
#pragma once

#include <array>
#include <string_view>

#include "plumb/predicates/determinant.hpp"

namespace plumb::predicates {

/// For counterclockwise a, b, c: positive when d is inside their circle.
struct InCircle {
  static constexpr std::string_view name = "incircle";
  static constexpr int points = 4, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& p) const {
    const auto ax = p[0] - p[6], ay = p[1] - p[7];
    const auto bx = p[2] - p[6], by = p[3] - p[7];
    const auto cx = p[4] - p[6], cy = p[5] - p[7];
    const auto a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
    return a2 * det2(bx, by, cx, cy) - b2 * det2(ax, ay, cx, cy) + c2 * det2(ax, ay, bx, by);
  }
};

/// For orient3d(a, b, c, d) > 0: positive when e is inside the sphere of a, b, c, d.
struct InSphere {
  static constexpr std::string_view name = "insphere";
  static constexpr int points = 5, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    const auto ax = p[0] - p[12], ay = p[1] - p[13], az = p[2] - p[14];
    const auto bx = p[3] - p[12], by = p[4] - p[13], bz = p[5] - p[14];
    const auto cx = p[6] - p[12], cy = p[7] - p[13], cz = p[8] - p[14];
    const auto dx = p[9] - p[12], dy = p[10] - p[13], dz = p[11] - p[14];
    // Six minors of the x and y columns serve all four 3x3 minors.
    const auto ab = det2(ax, ay, bx, by), bc = det2(bx, by, cx, cy), cd = det2(cx, cy, dx, dy);
    const auto da = det2(dx, dy, ax, ay), ac = det2(ax, ay, cx, cy), bd = det2(bx, by, dx, dy);
    const auto abc = az * bc - bz * ac + cz * ab;
    const auto bcd = bz * cd - cz * bd + dz * bc;
    const auto cda = cz * da + dz * ac + az * cd;
    const auto dab = dz * ab + az * bd + bz * da;
    const auto a2 = ax * ax + ay * ay + az * az, b2 = bx * bx + by * by + bz * bz;
    const auto c2 = cx * cx + cy * cy + cz * cz, d2 = dx * dx + dy * dy + dz * dz;
    return (d2 * abc - c2 * dab) + (b2 * cda - a2 * bcd);
  }
};

}  // namespace plumb::predicates
