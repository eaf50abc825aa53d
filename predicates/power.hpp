// Which weighted point governs a place?  The power of x from a point c of weight w is |cx|^2 - w: from a sphere, with
// its squared radius as the weight.
//
// Laws: equal weights everywhere give incircle, insphere and the comparison of distances; adding one number to all
// weights changes nothing, but in power_product; swapping two of the points that span a power circle (sphere) flips the
// sign; common translation changes nothing.  A weight has the degree of a squared distance, and may be negative.
// Source: RTCD 3.1.6.3, 3.1.6.4, with lifted points moved by their weight (Aurenhammer 1987, power diagrams).
#pragma once

#include <array>
#include <string_view>

#include "plumb/predicates/determinant.hpp"

namespace plumb::predicates {

/// For counterclockwise a, b, c: positive when the power of d from the circle orthogonal to all three is less than its
/// weight, so that d belongs into a regular triangulation before the triangle does.
struct PowerCircle {
  static constexpr std::string_view name = "power_circle", axes = "xyw";
  static constexpr int points = 4, dimension = 3;
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    const auto ax = p[0] - p[9], ay = p[1] - p[10], aw = p[2] - p[11];
    const auto bx = p[3] - p[9], by = p[4] - p[10], bw = p[5] - p[11];
    const auto cx = p[6] - p[9], cy = p[7] - p[10], cw = p[8] - p[11];
    const auto a2 = ax * ax + ay * ay - aw, b2 = bx * bx + by * by - bw, c2 = cx * cx + cy * cy - cw;
    return a2 * det2(bx, by, cx, cy) - b2 * det2(ax, ay, cx, cy) + c2 * det2(ax, ay, bx, by);
  }
};

/// For orient3d(a, b, c, d) > 0: positive when the power of e from the sphere orthogonal to all four is less than its
/// weight.
struct PowerSphere {
  static constexpr std::string_view name = "power_sphere", axes = "xyzw";
  static constexpr int points = 5, dimension = 4;
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 20>& p) const {
    const auto ax = p[0] - p[16], ay = p[1] - p[17], az = p[2] - p[18], aw = p[3] - p[19];
    const auto bx = p[4] - p[16], by = p[5] - p[17], bz = p[6] - p[18], bw = p[7] - p[19];
    const auto cx = p[8] - p[16], cy = p[9] - p[17], cz = p[10] - p[18], cw = p[11] - p[19];
    const auto dx = p[12] - p[16], dy = p[13] - p[17], dz = p[14] - p[18], dw = p[15] - p[19];
    const auto ab = det2(ax, ay, bx, by), bc = det2(bx, by, cx, cy), cd = det2(cx, cy, dx, dy);
    const auto da = det2(dx, dy, ax, ay), ac = det2(ax, ay, cx, cy), bd = det2(bx, by, dx, dy);
    const auto abc = az * bc - bz * ac + cz * ab;
    const auto bcd = bz * cd - cz * bd + dz * bc;
    const auto cda = cz * da + dz * ac + az * cd;
    const auto dab = dz * ab + az * bd + bz * da;
    const auto a2 = ax * ax + ay * ay + az * az - aw, b2 = bx * bx + by * by + bz * bz - bw;
    const auto c2 = cx * cx + cy * cy + cz * cz - cw, d2 = dx * dx + dy * dy + dz * dz - dw;
    return (d2 * abc - c2 * dab) + (b2 * cda - a2 * bcd);
  }
};

/// The power of the point a from the weighted point b against that from the weighted point c.
struct ComparePower2d {
  static constexpr std::string_view name = "compare_power2d", axes = "xyw";
  static constexpr std::array arguments{2, 3, 3};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& p) const {
    return (p[2] - p[5]) * ((p[2] - p[0]) + (p[5] - p[0])) + (p[3] - p[6]) * ((p[3] - p[1]) + (p[6] - p[1])) -
           (p[4] - p[7]);
  }
};

struct ComparePower3d {
  static constexpr std::string_view name = "compare_power3d", axes = "xyzw";
  static constexpr std::array arguments{3, 4, 4};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 11>& p) const {
    return (p[3] - p[7]) * ((p[3] - p[0]) + (p[7] - p[0])) + (p[4] - p[8]) * ((p[4] - p[1]) + (p[8] - p[1])) +
           (p[5] - p[9]) * ((p[5] - p[2]) + (p[9] - p[2])) - (p[6] - p[10]);
  }
};

/// |ab|^2 against the sum of the weights: zero when the circles are orthogonal; with a of weight zero the sign of its
/// power from b.
struct PowerProduct2d {
  static constexpr std::string_view name = "power_product2d", axes = "xyw";
  static constexpr int points = 2, dimension = 3;
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    const auto x = p[0] - p[3], y = p[1] - p[4];
    return x * x + y * y - (p[2] + p[5]);
  }
};

struct PowerProduct3d {
  static constexpr std::string_view name = "power_product3d", axes = "xyzw";
  static constexpr int points = 2, dimension = 4;
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& p) const {
    const auto x = p[0] - p[4], y = p[1] - p[5], z = p[2] - p[6];
    return x * x + y * y + z * z - (p[3] + p[7]);
  }
};

}  // namespace plumb::predicates
