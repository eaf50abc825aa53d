// Closest points: is a ball or capsule nearer than this to a triangle, a box, a segment?  Guesses of nearest points in
// doubles, and their proof.
//
// Laws: an answer is the sign of the distance minus the radius, proved: by two points that are nearer, or by a
// direction along which everything is farther; none where doubles prove neither, nor for a negative radius or a number
// that is not real, but of a box with the axes of space: who calls has looked.
// Source: RTCD 5.1.2, 5.1.3, 5.1.4, 5.1.5, 5.1.9; docs/proof.md, "Tracked errors".
// Cost: some 10 to 30 ns.
#pragma once

#include <algorithm>
#include <optional>

#include "arith/vec.hpp"
#include "plumb/certify/certainly.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::figure::near_points {

using arith::Plain;

/// A vector of a world's numbers.
template <class T>
struct Way {
  T x, y, z;
};
template <class T>
Way(T, T, T) -> Way<T>;
template <class A, class B>
[[gnu::always_inline]] inline auto dot(const Way<A>& a, const Way<B>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class A, class B>
[[gnu::always_inline]] inline auto operator+(const Way<A>& a, const Way<B>& b) {
  return Way{a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class A, class B>
[[gnu::always_inline]] inline auto operator-(const Way<A>& a, const Way<B>& b) {
  return Way{a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class A, class B>
[[gnu::always_inline]] inline auto operator*(const Way<A>& a, const B& b) {
  return Way{a.x * b, a.y * b, a.z * b};
}
template <std::size_t scale>
[[gnu::always_inline]] inline auto way(auto& w, const auto& to, const auto& from) {
  return Way{w.template difference<scale>(to.x, from.x), w.template difference<scale>(to.y, from.y),
             w.template difference<scale>(to.z, from.z)};
}
template <std::size_t scale>
[[gnu::always_inline]] inline auto way(auto& w, const auto& v) {
  return Way{w.template number<scale>(v.x), w.template number<scale>(v.y), w.template number<scale>(v.z)};
}

/// Scales: what lies between the figures, and in it the radii and the parts of edges; the edges; the direction.
struct Proof {
  static constexpr int highest = 4;
  static constexpr Scales scales{.count = 3, .weights = 0b10};

  /// What lies no nearer than `low` along n.
  template <class W>
  [[gnu::always_inline]] static bool is_far(W& w, const auto& n, const auto& low, const auto& square) {
    return w.positive(low) && w.positive(low * low - square * dot(n, n));
  }
  /// Of points that are `off` apart as well; first it is asked for what is likely.
  template <Sign likely, class W>
  [[gnu::always_inline]] static Sign judged(W& w, const auto& off, const auto& n, const auto& low, const auto& reach) {
    const auto square = reach * reach;
    if (likely == Sign::positive && is_far(w, n, low, square)) return Sign::positive;
    if (w.positive(square - dot(off, off))) return Sign::negative;
    if (likely == Sign::negative && is_far(w, n, low, square)) return Sign::positive;
    w.leave_open();
    return Sign::zero;
  }
};

/// The point of the triangle at these parts of its edges from a, which add up to 1 at most.
struct OfTriangle : Proof {
  template <class W>
  [[gnu::always_inline]] Sign operator()(W& w, const Triangle3& t, const Point3& center, double radius, double b,
                                         double c, const Plain& direction) const {
    const auto ap = way<0>(w, center, t.a);
    const auto ab = way<1>(w, t.b, t.a), ac = way<1>(w, t.c, t.a);
    const auto off = ap - ab * w.template weight<1>(w.given(b)) - ac * w.template weight<1>(w.given(c));
    const auto n = way<2>(w, direction);
    const auto back = dot(n, ab), other = dot(n, ac);
    const auto most = larger(larger(back, other), back - back) * w.template weight<1>(w.given(1.0));
    return judged<Sign::positive>(w, off, n, dot(n, ap) - most, w.number(radius));
  }
};

/// The points at these parts of both segments.
struct OfSegments : Proof {
  template <class W>
  [[gnu::always_inline]] Sign operator()(W& w, const Segment3& pq, const Segment3& xy, double radius_pq,
                                         double radius_xy, double s, double t, const Plain& direction) const {
    const auto r = way<0>(w, pq.a, xy.a);
    const auto d = way<1>(w, pq.b, pq.a), e = way<1>(w, xy.b, xy.a);
    const auto off = r + d * w.template weight<1>(w.given(s)) - e * w.template weight<1>(w.given(t));
    const auto n = way<2>(w, direction);
    const auto up = dot(n, d), down = dot(n, e);
    const auto none = up - up;
    const auto least = (smaller(up, none) - larger(down, none)) * w.template weight<1>(w.given(1.0));
    return judged<Sign::negative>(w, off, n, dot(n, r) + least, w.sum(w.given(radius_pq), w.given(radius_xy)));
  }
};

/// The point of the segment at this part, and q of the box; its `corner` lies farthest along the direction.
struct OfAabb : Proof {
  template <class W>
  [[gnu::always_inline]] Sign operator()(W& w, const Plain& q, const Plain& corner, const Segment3& pq, double radius,
                                         double part, const Plain& direction) const {
    const auto from_q = way<0>(w, pq.a, q), from_corner = way<0>(w, pq.a, corner);
    const auto d = way<1>(w, pq.b, pq.a);
    const auto n = way<2>(w, direction);
    const auto along = dot(n, d);
    const auto least = smaller(along, along - along) * w.template weight<1>(w.given(1.0));
    return judged<Sign::negative>(w, from_q + d * w.template weight<1>(w.given(part)), n, dot(n, from_corner) + least,
                                  w.number(radius));
  }
};

template <class Statement, class... Input>
[[gnu::always_inline]] inline std::optional<Sign> told(const Input&... input) {
  return certify::one_lane::told_by_worlds<FloatWorld<Statement>>(NoWorldRecorder{}, Statement{}, input...);
}

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
  constexpr double less = 1 - 0x1p-50;  // a guess well within the triangle: parts below 1 in doubles are so exactly
  const double share = less / (u + v + w);
  v *= share, w *= share;
  if (!(v >= 0 && w >= 0 && v + w < 1 && radius >= 0)) return {};
  return told<OfTriangle>(t, center, radius, v, w, ap - ab * v - ac * w);
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
  if (!(radius_pq >= 0 && radius_xy >= 0)) return {};
  return told<OfSegments>(pq, xy, radius_pq, radius_xy, s, t, r + d * s - e * t);
}

/// Of a box that is not empty.
[[gnu::always_inline]] inline std::optional<Sign> quick_gap(const Aabb3& box, const Segment3& pq, double radius) {
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
    if (!(radius >= 0)) break;
    if (const auto sign = told<OfAabb>(q, near, pq, radius, s, off)) return sign;
    const double along = arith::dot(off, d);
    const double next = square > 0 ? std::clamp(s - along / square, 0.0, 1.0) : 0;
    if (next == s) break;
    s = next;
  }
  return {};
}

}  // namespace plumb::figure::near_points
