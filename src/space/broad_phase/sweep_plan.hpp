// Along which axis are boxes swept, and in how many rows and layers of columns?  Chosen by a sample.
//
// A guess throughout: any plan finds the same pairs, at another cost.
// Law: a plan depends on the numbers of the boxes alone.
// Source: RTCD 7.1.1, 7.5.
// Cost: some 40 us for 256 boxes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace plumb::space {

struct SweepPlan {
  std::array<std::size_t, 3> order{0, 1, 2};   // the axis of the sweep, then those that columns divide
  std::array<std::uint32_t, 2> columns{1, 1};  // along each of these
  double windows = 0;                          // pairs of boxes that are compared, as the sample tells
  double copies = 1;                           // of each box, in columns
};

/// Boxes of a sample, scaled to [0, 1] on each axis.
struct SampledBox {
  std::array<float, 3> low, high;
};

/// For n boxes of which these are some.
SweepPlan plan_sweep(std::span<const SampledBox> sample, std::size_t n);

}  // namespace plumb::space
