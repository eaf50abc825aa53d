// When can a box that moves along a line first meet one that stands still?  No later than they do; infinite where
// never.
//
// Rounding keeps order, so each operation that may round is followed by a step outward
// (space/closest/box_distance.hpp).
#pragma once

#include <algorithm>
#include <limits>

#include "plumb/arith/rational.hpp"
#include "plumb/figure/basic/box.hpp"
#include "space/closest/box_distance.hpp"

namespace plumb::space {

/// Narrows [enter, leave] to when [low, high] moved by v t meets [from, to]; at least to all such t.
inline void narrow_times(double low, double high, double v, double from, double to, double& enter, double& leave) {
  if (v < 0) return narrow_times(-high, -low, -v, -to, -from, enter, leave);
  if (low > to || (v == 0 && high < from)) {
    enter = std::numeric_limits<double>::infinity();
    return;
  }
  if (v == 0) return;
  if (high < from) enter = std::max(enter, step_below(step_below(from - high) / v));
  leave = std::min(leave, step_above(step_above(to - low) / v));
}

/// Within time [0, 1].
inline double entry_below(const Aabb3& a, const Vector3& by, const Aabb3& b) {
  double enter = 0, leave = 1;
  narrow_times(a.min.x, a.max.x, by.x, b.min.x, b.max.x, enter, leave);
  narrow_times(a.min.y, a.max.y, by.y, b.min.y, b.max.y, enter, leave);
  narrow_times(a.min.z, a.max.z, by.z, b.min.z, b.max.z, enter, leave);
  return enter > leave ? std::numeric_limits<double>::infinity() : enter;
}

/// The exact time, where entry_below is no infinity.
inline Rational exact_entry(const Aabb3& a, const Vector3& by, const Aabb3& b) {
  Rational enter(0);
  const auto narrow = [&](double low, double high, double v, double from, double to) {
    if (v > 0 && high < from) enter = std::max(enter, (Rational(from) - Rational(high)) / Rational(v));
    if (v < 0 && low > to) enter = std::max(enter, (Rational(to) - Rational(low)) / Rational(v));
  };
  narrow(a.min.x, a.max.x, by.x, b.min.x, b.max.x);
  narrow(a.min.y, a.max.y, by.y, b.min.y, b.max.y);
  narrow(a.min.z, a.max.z, by.z, b.min.z, b.max.z);
  return enter;
}

}  // namespace plumb::space
