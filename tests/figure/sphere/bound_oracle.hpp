// What is the exact bound?  Rational intervals and images, written from the definitions.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "figure/basic/shape_cases.hpp"

namespace plumb::bound_oracle {

using Rational = mpq_class;
using Rational3 = std::array<Rational, 3>;

inline Rational3 rational(const Point3& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }
inline Rational3 rational(const Vector3& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }

inline Rational3 sum(const Rational3& a, const Rational3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Rational3 times(const Rational& f, const Rational3& a) { return {f * a[0], f * a[1], f * a[2]}; }
inline Rational dot(const Rational3& a, const Rational3& b) {
  return Rational(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

inline Rational3 image(const Rational3& p, const Pose& pose) {
  Rational3 r = rational(pose.translation);
  for (std::size_t i = 0; i < 3; ++i) r = sum(r, times(p[i], rational(pose.columns[i])));
  return r;
}

inline double next_up(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
inline double next_down(double x) { return std::nextafter(x, -std::numeric_limits<double>::infinity()); }

/// Is it the largest double not above, the smallest not below?
inline bool is_rounded_down(double x, const Rational& exact) {
  const double up = next_up(x);
  return Rational(x) <= exact && (std::isinf(up) || Rational(up) > exact);
}
inline bool is_rounded_up(double x, const Rational& exact) { return is_rounded_down(-x, Rational(-exact)); }

inline bool is_beyond_doubles(const Rational& exact) {
  return abs(exact) > Rational(std::numeric_limits<double>::max());
}

struct Range {
  Rational min, max;
  void add(const Rational& x) {
    if (x < min) min = x;
    if (x > max) max = x;
  }
};

/// Relation of two products of intervals: the interiors (a point's is the point) share a point or not.
template <std::size_t n>
Relation relation(const std::array<Range, n>& a, const std::array<Range, n>& b) {
  bool overlap = true;
  for (std::size_t i = 0; i < n; ++i) {
    if (a[i].min > a[i].max || b[i].min > b[i].max) return Relation::disjoint;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Rational from = a[i].min > b[i].min ? a[i].min : b[i].min, to = a[i].max < b[i].max ? a[i].max : b[i].max;
    if (from > to) return Relation::disjoint;
    const Rational middle = (from + to) / 2;
    for (const Range& r : {a[i], b[i]}) overlap = overlap && (r.min == r.max || (r.min < middle && middle < r.max));
  }
  return overlap ? Relation::overlapping : Relation::touching;
}

/// A halfspace normal . x <= limit, or < limit.
struct Half {
  std::vector<Rational> normal;
  Rational limit;
  bool open;
};

/// Is there a point in all of them?  Fourier and Motzkin's elimination, one variable after the other.
inline bool have_point(std::vector<Half> halves, std::size_t dimension) {
  for (std::size_t v = 0; v < dimension; ++v) {
    std::vector<Half> next;
    for (const Half& h : halves) {
      if (h.normal[v] == 0) next.push_back(h);
    }
    for (const Half& up : halves) {
      if (up.normal[v] <= 0) continue;
      for (const Half& down : halves) {
        if (down.normal[v] >= 0) continue;
        Half both{std::vector<Rational>(dimension), up.limit * -down.normal[v] + down.limit * up.normal[v],
                  up.open || down.open};
        for (std::size_t k = 0; k < dimension; ++k)
          both.normal[k] = up.normal[k] * -down.normal[v] + down.normal[k] * up.normal[v];
        // Of halfspaces with one normal, the strictest will do.
        bool known = false;
        for (Half& h : next) {
          if (h.normal != both.normal) continue;
          known = true;
          if (both.limit < h.limit || (both.limit == h.limit && both.open)) h = both;
        }
        if (!known) next.push_back(both);
      }
    }
    halves = std::move(next);
  }
  return std::ranges::all_of(halves, [](const Half& h) { return h.limit > 0 || (h.limit == 0 && !h.open); });
}

}  // namespace plumb::bound_oracle
