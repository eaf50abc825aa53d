// Closest points: is a ball or capsule nearer than this to a triangle, a box, a segment?  Nearest points in doubles,
// and their proof.
//
// Laws: an answer is the sign of the distance minus the radius, proved: by two points that are nearer, or by a
// direction along which everything is farther; none where doubles prove neither, nor for a negative radius or a number
// that is not real, but of a box with the axes of space: who calls has looked.
// Source: RTCD 5.1.2, 5.1.3, 5.1.4, 5.1.5, 5.1.9.
// Cost: some 10 to 30 ns.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "arith/vec.hpp"
#include "plumb/arith/filtered.hpp"
#include "plumb/arith/sign.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::figure::near_points {

using arith::Plain;

inline double sum_of_sizes(const Plain& v) { return magnitude_of(v.x) + magnitude_of(v.y) + magnitude_of(v.z); }

/// What two near points show, `off` apart, the one sought less the other; `low` is the least height along `off` of what
/// lies on the one's side over what lies on the other's.
///
/// Let `sizes` be the sum of the sizes of the coordinates of all differences of input points, and of half extents times
/// axes, that both are sums of, with parts of at most 1.  A coordinate of `off` rounds each of its terms twice and adds
/// up to six, so that all are off by no more than 16 u sizes together, and a height by no more than 16 u sizes times
/// the sum of the sizes of `off`; 64 u pays for what the bounds round, for the rounded sum of two radii, and for parts
/// that add up to 1 + 4 u.  The guards pay for underflow, of squares and of products of two; up to `most` nothing
/// overflows, and a NaN or infinity is never below it.
struct NearPoints {
  Plain off;
  double low, sizes;

  [[nodiscard]] std::optional<Sign> proof(double reach) const {
    constexpr double unsure = 0x1p-47, more = 1 + 0x1p-40, tiny = 0x1p-1060, guard = 0x1p-900, most = 0x1p250;
    const double square = arith::dot(off, off), inner = reach - unsure * (sizes + reach);
    const double above = low - (unsure * sizes * sum_of_sizes(off) + guard);
    const int near = static_cast<int>(inner > 0) & static_cast<int>(square * more + guard < inner * inner);
    const int far =
        static_cast<int>(above > 0) & static_cast<int>(above * above > (reach * reach * more + tiny) * square + guard);
    if (((near | far) & static_cast<int>(reach >= 0) & static_cast<int>(sizes + reach < most)) == 0) return {};
    return static_cast<Sign>(far - near);
  }
};

[[gnu::flatten]] inline std::optional<Sign> quick_gap(const Triangle3& t, const Point3& center, double radius) {
  const Plain a = arith::vec<double>(t.a), ab = arith::vec<double>(t.b) - a, ac = arith::vec<double>(t.c) - a,
              p = arith::vec<double>(center), ap = p - a;
  // Weights of the corners at the nearest point, times their sum.
  double u = 0, v = 0, w = 0;
  const double d1 = arith::dot(ab, ap), d2 = arith::dot(ac, ap);
  const Plain bp = ap - ab, cp = ap - ac;
  const double d3 = arith::dot(ab, bp), d4 = arith::dot(ac, bp), d5 = arith::dot(ab, cp), d6 = arith::dot(ac, cp);
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (d1 <= 0 && d2 <= 0) {
    u = 1;
  } else if (d3 >= 0 && d4 <= d3) {
    v = 1;
  } else if (d6 >= 0 && d5 <= d6) {
    w = 1;
  } else if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    u = -d3, v = d1;
  } else if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    u = -d6, w = d2;
  } else if (va <= 0 && d4 >= d3 && d5 >= d6) {
    v = d5 - d6, w = d4 - d3;
  } else {
    u = va, v = vb, w = vc;
  }
  const double share = 1 / (u + v + w);
  v *= share, w *= share;
  if (!(v >= 0 && w >= 0 && v + w <= 1 + 0x1p-51)) return {};
  const Plain off = ap - ab * v - ac * w;
  const double back = arith::dot(off, ab), other = arith::dot(off, ac);
  const double low = arith::dot(off, ap) - (back > other ? (back > 0 ? back : 0) : (other > 0 ? other : 0));
  return NearPoints{off, low, sum_of_sizes(ap) + (sum_of_sizes(ab) + sum_of_sizes(ac))}.proof(radius);
}

[[gnu::flatten]] inline std::optional<Sign> quick_gap(const Obb3& box, const Point3& center, double radius) {
  const Plain d = arith::vec<double>(center) - arith::vec<double>(box.center);
  const std::array half{magnitude_of(box.half.x), magnitude_of(box.half.y), magnitude_of(box.half.z)};
  const std::array axis{arith::vec<double>(box.axes[0]), arith::vec<double>(box.axes[1]),
                        arith::vec<double>(box.axes[2])};
  Plain off = d;
  double sizes = sum_of_sizes(d);
  for (std::size_t i = 0; i < 3; ++i) {
    const double square = arith::dot(axis[i], axis[i]);
    const double t = square > 0 ? std::clamp(arith::dot(d, axis[i]) / square, -half[i], half[i]) : 0;
    off = off - axis[i] * t;
    sizes += half[i] * sum_of_sizes(axis[i]);
  }
  double low = arith::dot(off, d);
  // With the half extent first: what a product loses by underflow would grow with it.
  for (std::size_t i = 0; i < 3; ++i) low -= magnitude_of(arith::dot(off, axis[i] * half[i]));
  return NearPoints{off, low, sizes}.proof(radius);
}

/// Of two segments pq and xy.
[[gnu::flatten]] inline std::optional<Sign> quick_gap(const Segment3& pq, const Segment3& xy, double radius_pq,
                                                      double radius_xy) {
  const Plain p = arith::vec<double>(pq.a), x = arith::vec<double>(xy.a), d = arith::vec<double>(pq.b) - p,
              e = arith::vec<double>(xy.b) - x, r = p - x;
  const double a = arith::dot(d, d), c = arith::dot(e, e), f = arith::dot(e, r), g = arith::dot(d, r),
               b = arith::dot(d, e);
  const double area = a * c - b * b;
  double s = area > 0 ? std::clamp((b * f - g * c) / area, 0.0, 1.0) : 0;
  double t = c > 0 ? (b * s + f) / c : 0;
  if (!(t > 0)) {
    t = 0;
    s = a > 0 ? std::clamp(-g / a, 0.0, 1.0) : 0;
  } else if (!(t < 1)) {
    t = 1;
    s = a > 0 ? std::clamp((b - g) / a, 0.0, 1.0) : 0;
  }
  const Plain off = r + d * s - e * t;
  const double up = arith::dot(off, d), down = -arith::dot(off, e);
  const double low = arith::dot(off, r) + (std::min(up, 0.0) + std::min(down, 0.0));
  if (!(radius_pq >= 0 && radius_xy >= 0)) return {};
  return NearPoints{off, low, sum_of_sizes(r) + (sum_of_sizes(d) + sum_of_sizes(e))}.proof(radius_pq + radius_xy);
}

/// Of a box that is not empty.
[[gnu::flatten]] inline std::optional<Sign> quick_gap(const Aabb3& box, const Segment3& pq, double radius) {
  // Rounding keeps order: a difference that is rounded above the radius is above it.
  const auto past = [&](double low, double high, double from, double to) {
    const double below = low - std::max(from, to), above = std::min(from, to) - high;
    return (below > radius) | (above > radius);
  };
  if (past(box.min.x, box.max.x, pq.a.x, pq.b.x) || past(box.min.y, box.max.y, pq.a.y, pq.b.y) ||
      past(box.min.z, box.max.z, pq.a.z, pq.b.z))
    return Sign::positive;
  constexpr int most_rounds = 12;
  const Plain p = arith::vec<double>(pq.a), d = arith::vec<double>(pq.b) - p;
  const double square = arith::dot(d, d);
  double s = 0.5;
  for (int round = 0; round < most_rounds; ++round) {
    const Plain at = p + d * s;
    const Plain q{std::clamp(at.x, box.min.x, box.max.x), std::clamp(at.y, box.min.y, box.max.y),
                  std::clamp(at.z, box.min.z, box.max.z)};
    const auto corner = [](double n, double low, double high) { return n > 0 ? high : low; };
    const Plain from_q = p - q, off = from_q + d * s;
    const Plain near{corner(off.x, box.min.x, box.max.x), corner(off.y, box.min.y, box.max.y),
                     corner(off.z, box.min.z, box.max.z)};
    const Plain from_near = p - near;
    const double along = arith::dot(off, d), low = arith::dot(off, from_near) + std::min(along, 0.0);
    const double sizes = sum_of_sizes(from_q) + (sum_of_sizes(from_near) + sum_of_sizes(d));
    if (const auto sign = NearPoints{off, low, sizes}.proof(radius)) return sign;
    const double next = square > 0 ? std::clamp(s - along / square, 0.0, 1.0) : 0;
    if (next == s) break;
    s = next;
  }
  return {};
}

}  // namespace plumb::figure::near_points
