// When can a box that moves along a line first meet one that stands still?  No later than they do; infinite where
// never.
//
// The motion is known to lie between two vectors, which may be the same.
// Rounding keeps order, so each operation that may round is followed by a step outward
// (space/closest/box_distance.hpp).
#pragma once

#include <algorithm>
#include <limits>

#include "plumb/figure/basic/box.hpp"
#include "space/closest/box_distance.hpp"

namespace plumb::space {

/// Narrows [enter, leave] to when [low, high] moved by v t meets [from, to], for v from slow to fast; at least to all
/// such t.
inline void narrow_times(double low, double high, double slow, double fast, double from, double to, double& enter,
                         double& leave) {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (high < from) enter = fast > 0 ? std::max(enter, step_below(step_below(from - high) / fast)) : never;
  if (low > to) enter = slow < 0 ? std::max(enter, step_below(step_below(low - to) / -slow)) : never;
  if (slow > 0) leave = std::min(leave, step_above(step_above(std::max(to - low, 0.0)) / slow));
  if (fast < 0) leave = std::min(leave, step_above(step_above(std::max(high - from, 0.0)) / -fast));
}

/// Within time [0, 1].
inline double entry_below(const Aabb3& a, const Aabb3& by, const Aabb3& b) {
  double enter = 0, leave = 1;
  narrow_times(a.min.x, a.max.x, by.min.x, by.max.x, b.min.x, b.max.x, enter, leave);
  narrow_times(a.min.y, a.max.y, by.min.y, by.max.y, b.min.y, b.max.y, enter, leave);
  narrow_times(a.min.z, a.max.z, by.min.z, by.max.z, b.min.z, b.max.z, enter, leave);
  return enter > leave ? std::numeric_limits<double>::infinity() : enter;
}

}  // namespace plumb::space
