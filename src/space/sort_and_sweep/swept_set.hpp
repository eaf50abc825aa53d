// Boxes of one set or of two, sorted along one axis and swept: which overlap?
#pragma once

#include <algorithm>
#include <vector>

#include "plumb/space/sort_and_sweep/sort_and_sweep.hpp"
#include "space/sort_and_sweep/sorted_boxes.hpp"
#include "space/sort_and_sweep/sweep_lanes.hpp"

namespace plumb::space {

/// Takes blocks of pairs; `done` is the part of all work that is done, for who wants to know how many there may be.
struct PairTaker {
  void* to;
  void (*take)(void* to, std::span<const BoxPair> block, double done);
};

/// Of middles, halved and divided by the largest magnitude: no sum is beyond doubles.  A guess.
template <class Box>
std::size_t widest_axis(const BoxSet<Box>& set, const SetBounds& bounds) {
  constexpr std::size_t axes = axes_of<Box>;
  std::array<double, axes> sum{}, square{};
  double largest = 0;
  for (std::size_t k = 0; k < axes; ++k) {
    largest = std::max(largest, bounds.max[k] * 0.5 - bounds.min[k] * 0.5);
  }
  if (!(largest > 0)) return 0;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const auto x = numbers_of(set[i]);
    for (std::size_t k = 0; k < axes; ++k) {
      const double middle = (x[k] * 0.25 + x[k + axes] * 0.25 - bounds.min[k] * 0.5) / largest;
      sum[k] += middle, square[k] += middle * middle;
    }
  }
  const auto n = static_cast<double>(set.size());
  std::size_t best = 0;
  std::array<double, axes> variance;
  for (std::size_t k = 0; k < axes; ++k) {
    variance[k] = square[k] - sum[k] * (sum[k] / n);
    if (variance[k] > variance[best]) best = k;
  }
  return best;
}

/// Of boxes that are checked and have these bounds.
template <class Box>
void find_by_sweep(Execution execution, const BoxSet<Box>& set, const SetBounds& bounds, std::size_t axis,
                   const PairTaker& to) {
  const std::size_t n = set.size();
  if (n < 2) return;
  const OrdinalMap map(bounds, {axis, (axis + 1) % 3, (axis + 2) % 3}, {swept_bits(n), ordinal_bits, ordinal_bits});
  const auto sorted = sorted_ordinals(execution, set, map);
  SweptBoxes swept;
  swept.assign({sorted.get(), n});
  constexpr std::size_t block_size = 1 << 11;
  const DecidePair decide{&set, &decide_of_set<Box>};
  std::vector<std::vector<BoxPair>> found(blocks_of(n - 1, block_size));
  for_blocks(execution, n - 1, block_size, [&](std::size_t b, std::size_t from, std::size_t until) {
    PairBlock block(&found[b], [](void* context, std::span<const BoxPair> pairs) {
      auto& kept = *static_cast<std::vector<BoxPair>*>(context);
      kept.insert(kept.end(), pairs.begin(), pairs.end());
    });
    sweep(swept, from, until, decide, block);
    block.flush();
    if (execution == Execution::parallel) return;
    to.take(to.to, found[b], static_cast<double>(b + 1) / static_cast<double>(found.size()));
    found[b] = {};
  });
  if (execution == Execution::serial) return;
  for (std::size_t b = 0; b < found.size(); ++b) {
    to.take(to.to, found[b], static_cast<double>(b + 1) / static_cast<double>(found.size()));
  }
}

}  // namespace plumb::space
