// Is a ball or capsule nearer than this to a triangle, a box, a segment?  Nearest points in doubles, and their proof.
//
// Laws: an answer is the sign of the distance minus the radius, proved: by two points that are nearer, or by a
// direction along which everything is farther; none where doubles prove neither.  For numbers that are not real there
// may be an answer, though not of two segments: who calls has looked. Source: RTCD 5.1.2, 5.1.3, 5.1.4, 5.1.5, 5.1.9.
// Cost: some 10 to 30 ns.
#pragma once

#include <array>
#include <optional>

#include "core_distance.hpp"
#include "plumb/arith/approximate.hpp"
#include "plumb/arith/interval.hpp"
#include "plumb/figure/box.hpp"
#include "plumb/figure/linear.hpp"
#include "plumb/figure/simplex.hpp"

namespace plumb::near_points {

using Way = core::Vec<Approximate>;
using PlainVec = core::Vec<double>;

inline PlainVec plain(const Point3& p) { return {p.x, p.y, p.z}; }
inline PlainVec plain(const Vector3& v) { return {v.x, v.y, v.z}; }
inline Way exactly(const PlainVec& v) { return {Approximate(v.x), Approximate(v.y), Approximate(v.z)}; }
inline Way way(const Point3& from, const Point3& to) {
  return {Approximate::difference(to.x, from.x), Approximate::difference(to.y, from.y),
          Approximate::difference(to.z, from.z)};
}

/// The sign, where it is certain, else zero.
inline int certain_sign(const Approximate& x) {
  const double most = (x.error + Approximate::slack) * 0x1p-53 * x.magnitude;
  return static_cast<int>(x.value > most) - static_cast<int>(x.value < -most);
}

/// Bounds of the exact value: what Signs asks for, and two roundings more.
inline double off_by(const Approximate& x) { return (x.error + 2) * 0x1p-53 * x.magnitude; }
inline double lower(const Approximate& x) { return x.value - off_by(x); }
inline double upper_magnitude(const Approximate& x) { return magnitude_of(x.value) + off_by(x); }

/// What products of few positive numbers lose by rounding, and by underflow: of a square that is multiplied once more
/// `tiny` times the other factor.
inline constexpr double more = 1 + 0x1p-40, least_square = 0x1p-900, tiny = 0x1p-1060;

/// Is |way| / weight less than the reach, neither of them negative?
inline bool is_near(const Way& way, double reach, double weight) {
  const double x = upper_magnitude(way.x), y = upper_magnitude(way.y), z = upper_magnitude(way.z);
  const double limit = reach * weight;
  return (x * x + y * y + z * z) * more + least_square < limit * limit;
}

/// Are all heights over |n| more than the reach, which is not negative?  For |n| that is not less, in doubles.
template <class... Heights>
bool all_far(double reach, const PlainVec& n, const Heights&... heights) {
  double low = Interval::infinity;
  bool above = true;  // false where one is NaN
  ((above = above & (lower(heights) > 0), low = lower(heights) < low ? lower(heights) : low), ...);
  const double square = core::dot(n, n), limit = reach * reach * square * more + tiny * square + least_square;
  return above && low * low > limit;
}

inline double clamped(double x, double low, double high) { return x < low ? low : x > high ? high : x; }

[[gnu::flatten]] inline std::optional<Sign> quick_gap(const Triangle3& t, const Point3& center, double radius) {
  const PlainVec a = plain(t.a), ab = plain(t.b) - a, ac = plain(t.c) - a, p = plain(center), ap = p - a;
  // Weights of the corners at the nearest point, times their sum.
  double u = 0, v = 0, w = 0;
  const double d1 = core::dot(ab, ap), d2 = core::dot(ac, ap);
  const PlainVec bp = ap - ab, cp = ap - ac;
  const double d3 = core::dot(ab, bp), d4 = core::dot(ac, bp), d5 = core::dot(ab, cp), d6 = core::dot(ac, cp);
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
  const double whole = u + v + w, share = 1 / whole;
  const PlainVec off = ap - ab * (v * share) - ac * (w * share);
  const Way ta = way(t.a, center), tb = way(t.b, center), tc = way(t.c, center);
  if (core::dot(off, off) > radius * radius) {
    const Way n = exactly(off);
    if (all_far(radius, off, core::dot(n, ta), core::dot(n, tb), core::dot(n, tc))) return Sign::positive;
  } else if (u >= 0 && v >= 0 && w >= 0) {
    if (is_near(ta * Approximate(u) + tb * Approximate(v) + tc * Approximate(w), radius, whole)) return Sign::negative;
  }
  return {};
}

[[gnu::flatten]] inline std::optional<Sign> quick_gap(const Obb3& box, const Point3& center, double radius) {
  const PlainVec d = plain(center) - plain(box.center);
  const std::array half{magnitude_of(box.half.x), magnitude_of(box.half.y), magnitude_of(box.half.z)};
  std::array<double, 3> t{};
  PlainVec off = d;
  for (std::size_t i = 0; i < 3; ++i) {
    const PlainVec u = plain(box.axes[i]);
    const double square = core::dot(u, u);
    t[i] = square > 0 ? clamped(core::dot(d, u) / square, -half[i], half[i]) : 0;
    off = off - u * t[i];
  }
  const Way from = way(box.center, center), u = exactly(plain(box.axes[0])), v = exactly(plain(box.axes[1])),
            w = exactly(plain(box.axes[2]));
  if (core::dot(off, off) > radius * radius) {
    const Way n = exactly(off);
    const auto back = [&](const Way& axis, double h) {
      const Approximate along = core::dot(n, axis);
      return Approximate(magnitude_of(along.value), along.magnitude, along.error) * Approximate(h);
    };
    if (all_far(radius, off, core::dot(n, from) - (back(u, half[0]) + back(v, half[1]) + back(w, half[2]))))
      return Sign::positive;
  } else if (is_near(from - u * Approximate(t[0]) - v * Approximate(t[1]) - w * Approximate(t[2]), radius, 1)) {
    return Sign::negative;
  }
  return {};
}

/// Of two segments pq and xy.
[[gnu::flatten]] inline std::optional<Sign> quick_gap(const Segment3& pq, const Segment3& xy, double radius_pq,
                                                      double radius_xy) {
  const PlainVec p = plain(pq.a), x = plain(xy.a), d = plain(pq.b) - p, e = plain(xy.b) - x, r = p - x;
  const double a = core::dot(d, d), c = core::dot(e, e), f = core::dot(e, r), g = core::dot(d, r), b = core::dot(d, e);
  const double area = a * c - b * b;
  double s = area > 0 ? clamped((b * f - g * c) / area, 0, 1) : 0;
  double t = c > 0 ? (b * s + f) / c : 0;
  if (!(t > 0)) {
    t = 0;
    s = a > 0 ? clamped(-g / a, 0, 1) : 0;
  } else if (!(t < 1)) {
    t = 1;
    s = a > 0 ? clamped((b - g) / a, 0, 1) : 0;
  }
  const PlainVec off = r + d * s - e * t;
  const double sum = radius_pq + radius_xy;
  const Way from = way(xy.a, pq.a), dw = way(pq.a, pq.b), ew = way(xy.a, xy.b);
  if (core::dot(off, off) > sum * sum) {
    const Way n = exactly(off);
    const Approximate h = core::dot(n, from), up = core::dot(n, dw), down = core::dot(n, ew);
    if (all_far(sum, off, h, h + up, h - down, (h + up) - down)) return Sign::positive;
  } else if (is_near(from + dw * Approximate(s) - ew * Approximate(t), sum, 1)) {
    return Sign::negative;
  }
  return {};
}

/// Of a box that is not empty.
[[gnu::flatten]] inline std::optional<Sign> quick_gap(const Aabb3& box, const Segment3& pq, double radius) {
  const auto past = [&](double low, double high, double from, double to) {
    const double first = from < to ? from : to, last = from < to ? to : from;
    const double limit = radius * more;  // a difference of two doubles is rounded once
    return (low - last > limit) | (first - high > limit);
  };
  if (past(box.min.x, box.max.x, pq.a.x, pq.b.x) || past(box.min.y, box.max.y, pq.a.y, pq.b.y) ||
      past(box.min.z, box.max.z, pq.a.z, pq.b.z))
    return Sign::positive;
  constexpr int most_rounds = 12;
  const PlainVec p = plain(pq.a), d = plain(pq.b) - p;
  const double square = core::dot(d, d);
  const Way dw = way(pq.a, pq.b);
  double s = 0.5;
  for (int round = 0; round < most_rounds; ++round) {
    const PlainVec at = p + d * s;
    const Point3 q{clamped(at.x, box.min.x, box.max.x), clamped(at.y, box.min.y, box.max.y),
                   clamped(at.z, box.min.z, box.max.z)};
    const PlainVec off = at - plain(q);
    const double gap = core::dot(off, off);
    if (gap < radius * radius) {
      if (is_near(way(q, pq.a) + dw * Approximate(s), radius, 1)) return Sign::negative;
      return {};
    }
    const auto corner = [](double n, double low, double high) { return n > 0 ? high : low; };
    const Point3 near{corner(off.x, box.min.x, box.max.x), corner(off.y, box.min.y, box.max.y),
                      corner(off.z, box.min.z, box.max.z)};
    const Way n = exactly(off);
    const Approximate h = core::dot(n, way(near, pq.a));
    if (all_far(radius, off, h, h + core::dot(n, dw))) return Sign::positive;
    const double next = square > 0 ? clamped(s - core::dot(off, d) / square, 0, 1) : 0;
    if (next == s) break;
    s = next;
  }
  return {};
}

}  // namespace plumb::near_points
