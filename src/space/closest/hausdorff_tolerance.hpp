// Is a Hausdorff distance known as well as was asked for?
#pragma once

#include <algorithm>

#include "plumb/arith/interval.hpp"
#include "plumb/space/closest/hausdorff.hpp"

namespace plumb::space {

/// Law (2) of hausdorff.hpp; `extent` is that of the larger mesh.
inline bool is_near_enough(const HausdorffOptions& options, double extent, const Interval& distance) {
  const double of_size = (Interval(options.of_size) * Interval(extent)).lower;
  const double of_most = (Interval(options.relative) * Interval(distance.upper)).lower;
  return (Interval(distance.upper) - Interval(distance.lower)).upper <= std::max({options.absolute, of_size, of_most});
}

}  // namespace plumb::space
