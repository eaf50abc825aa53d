// What angle has a vector of the plane?  Between which doubles it lies, and pi.
//
// Laws: the interval contains the exact angle of every vector whose coordinates are in the intervals given, in [0, pi].
// Source: Machin 1706; the series alternates, and so two sums in a row have its limit between them; tan(a / 2) of tan(a).
// Cost: some 200 operations on intervals.
#pragma once

#include <algorithm>

#include "plumb/arith/interval.hpp"

namespace plumb {

inline Interval hull_of(Interval a, Interval b) { return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)}; }

/// Takes what is in [0, 1/4].
inline Interval arc_tangent_series(Interval x) {
  const Interval square = x * x;
  Interval power = x, sum = x, before = x;
  for (int k = 1; k < 16; ++k) {
    power = power * square;
    const Interval term = quotient(power, Interval(2 * k + 1));
    before = sum;
    sum = k % 2 == 1 ? sum - term : sum + term;
  }
  return hull_of(before, sum);
}

inline Interval pi_between() {
  const Interval fifth = quotient(Interval(1), Interval(5)), least = quotient(Interval(1), Interval(239));
  return Interval(16) * arc_tangent_series(fifth) - Interval(4) * arc_tangent_series(least);
}

/// Takes what is in [0, 1].
inline Interval arc_tangent(Interval x) {
  const auto half = [](Interval t) { return quotient(t, Interval(1) + root(Interval(1) + t * t)); };
  return Interval(4) * arc_tangent_series(half(half(x)));
}

/// Takes the vector (x, y), y not below zero.
inline Interval angle_of_vector(double x, double y, Interval pi) {
  const Interval right = Interval(0.5) * pi;
  const double size = x < 0 ? -x : x;
  if (!(size + y < Interval::infinity) || (x == 0 && y == 0)) return {0, pi.upper};
  if (y <= size) {
    const Interval angle = arc_tangent(quotient(Interval(y), Interval(size)));
    return x > 0 ? angle : pi - angle;
  }
  const Interval angle = arc_tangent(quotient(Interval(size), Interval(y)));
  return x > 0 ? right - angle : right + angle;
}

/// Takes all vectors of these intervals: the angle falls as x grows, and grows with y where x is positive.
inline Interval angle_of_vectors(Interval x, Interval y, Interval pi) {
  const double low = std::max(y.lower, 0.0), high = std::max(y.upper, 0.0);
  const Interval least = angle_of_vector(x.upper, x.upper > 0 ? low : high, pi);
  const Interval most = angle_of_vector(x.lower, x.lower > 0 ? high : low, pi);
  return {std::max(0.0, least.lower), std::min(pi.upper, most.upper)};
}

}  // namespace plumb
