// Sort and sweep (sweep and prune): which of many boxes overlap?  Sorted along one axis from scratch, and swept.
//
//   sort_and_sweep_pairs(boxes)                                  // along the axis of greatest variance
//   sort_and_sweep_pairs(boxes, {.axis = SweepAxis::y})
//   axis_of_greatest_variance(boxes)
//
// Laws: (1) the pairs are those of brute_force_pairs, along whatever axis.  (2) They come by their earlier box along the
// axis; the order depends on the boxes and the axis alone, not on execution, threads or instruction set.
// A number that is NaN or infinite throws NonFinite, a box that is empty InvalidShape.
// Which axis has the greatest variance is told by floating point, as a guess of what is fast; of equal ones the first.
// Source: RTCD 7.5, 7.5.2; Cohen, Lin, Manocha and Ponamgi 1995.
// Cost: a radix sort, some 20 ns a box, and a comparison in the lanes of vectors with each box that starts within
// another along the axis: n^(5/3) of these for boxes all over space, of which the columns of overlapping_pairs leave a
// number in proportion to n.  Bounded by n^2 comparisons.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/space/pairs/float_boxes.hpp"
#include "plumb/space/pairs/pair_sink.hpp"

namespace plumb {

enum class SweepAxis : std::uint8_t { x, y, z, greatest_variance };

struct SortAndSweepOptions {
  bool touching = true;  // false: only the pairs that overlap
  Execution execution = Execution::parallel;
  SweepAxis axis = SweepAxis::greatest_variance;  // z in the plane throws InvalidShape
};

std::vector<BoxPair> sort_and_sweep_pairs(std::span<const Aabb2> boxes, const SortAndSweepOptions& options = {},
                                          std::vector<BoxPair> rows = {});
std::vector<BoxPair> sort_and_sweep_pairs(std::span<const Aabb3> boxes, const SortAndSweepOptions& options = {},
                                          std::vector<BoxPair> rows = {});
std::vector<BoxPair> sort_and_sweep_pairs(std::span<const FloatBox2> boxes, const SortAndSweepOptions& options = {},
                                          std::vector<BoxPair> rows = {});
std::vector<BoxPair> sort_and_sweep_pairs(std::span<const FloatBox3> boxes, const SortAndSweepOptions& options = {},
                                          std::vector<BoxPair> rows = {});

/// Of the boxes' middles.
SweepAxis axis_of_greatest_variance(std::span<const Aabb2> boxes);
SweepAxis axis_of_greatest_variance(std::span<const Aabb3> boxes);
SweepAxis axis_of_greatest_variance(std::span<const FloatBox2> boxes);
SweepAxis axis_of_greatest_variance(std::span<const FloatBox3> boxes);

}  // namespace plumb
