// Boxes in columns, each swept along its length: which overlap?
//
// Law: the order of pairs depends on the boxes and `touching` alone.
// Source: RTCD 7.1, 7.5.2.
#pragma once

#include <algorithm>
#include <vector>

#include "space/broad_phase/columns.hpp"
#include "space/broad_phase/sweep_plan.hpp"
#include "space/bvh/blocks.hpp"
#include "space/sort_and_sweep/swept_set.hpp"

namespace plumb::space {

/// Where the boxes are placed, and along which columns they are swept.
struct PlacedSweep {
  OrdinalMap map;
  SweepPlan plan;
};

/// By a sample of the boxes; a guess.
template <class Box>
PlacedSweep place_sweep(const BoxSet<Box>& set, const SetBounds& bounds) {
  constexpr std::size_t most = 256, axes = axes_of<Box>;
  const std::size_t n = set.size(), m = std::min(n, std::clamp<std::size_t>(n / 32, 64, most));
  const std::array<int, 3> all_bits{ordinal_bits, ordinal_bits, ordinal_bits};
  const auto plan_by = [&](const OrdinalMap& map) {
    std::vector<SampledBox> sample(m);  // guesses, by which columns are chosen and nothing is decided
    for (std::size_t i = 0; i < m; ++i) {
      const OrdinalBox b = map(set[i * n / m], 0, 0);
      for (std::size_t k = 0; k < 3; ++k) {
        sample[i].low[k] = static_cast<float>(b.low[k]) * 0x1p-30F;
        sample[i].high[k] = static_cast<float>(b.high[k]) * 0x1p-30F;
      }
    }
    return plan_sweep(sample, n);
  };
  const auto bits = std::array{swept_bits(n), ordinal_bits, ordinal_bits};
  const SweepPlan plan = plan_by(OrdinalMap(bounds, {0, 1, 2}, all_bits));
  constexpr double many = 64, gain = 0.25;  // comparisons of a box that are worth a second look, and fewer of them
  if (plan.windows < many * static_cast<double>(n)) return {OrdinalMap(bounds, plan.order, bits), plan};
  std::array<std::vector<double>, 3> knots;
  for (std::size_t i = 0; i < m; ++i) {
    const auto x = numbers_of(set[i * n / m]);
    for (std::size_t k = 0; k < axes; ++k) knots[k].push_back(x[k]), knots[k].push_back(x[k + axes]);
  }
  const SweepPlan other = plan_by(OrdinalMap(bounds, {0, 1, 2}, all_bits, knots));
  if (other.windows > gain * plan.windows) return {OrdinalMap(bounds, plan.order, bits), plan};
  return {OrdinalMap(bounds, other.order, bits, knots), other};
}

/// Columns whose boxes are many enough to be one thread's next work.
std::vector<std::size_t> groups_of(const Columns& columns);

/// Of boxes that are checked and have these bounds.
template <class Box>
void find_by_columns(Execution execution, const BoxSet<Box>& set, const SetBounds& bounds, const PairTaker& to) {
  const std::size_t n = set.size();
  auto [map, plan] = place_sweep(set, bounds);
  const auto sorted = sorted_ordinals(execution, set, map);
  Columns columns;
  const std::span<const OrdinalBox> in_order(sorted.get(), n);
  while (!divide_into_columns(execution, in_order, plan.columns, 4 * n + 4096, columns)) {
    for (auto& strips : plan.columns) strips = (strips + 1) / 2;
  }
  const DecidePair decide{&set, &decide_of_set<Box>};
  const std::vector<std::size_t> groups = groups_of(columns);
  const auto sweep_group = [&](std::size_t g, PairBlock& block, auto&& after) {
    SweptBoxes swept;
    for (std::size_t c = groups[g]; c < groups[g + 1]; ++c) {
      if (columns[c].size() < 2) continue;
      swept.assign(columns[c]);
      sweep(swept, 0, swept.size() - 1, decide, block);
      after(c);
    }
  };
  struct Told {
    const PairTaker* to;
    double done;
  };
  const auto all = static_cast<double>(columns.begin.back());
  Told told{&to, 0};
  PairBlock block(&told, [](void* context, std::span<const BoxPair> pairs) {
    const auto& [taker, done] = *static_cast<const Told*>(context);
    taker->take(taker->to, pairs, done);
  });
  if (execution == Execution::serial || groups.size() <= 2) {
    for (std::size_t g = 0; g + 1 < groups.size(); ++g) {
      sweep_group(g, block, [&](std::size_t c) { told.done = columns.begin[c + 1] / all; });
    }
    block.flush();
    return;
  }
  std::vector<std::vector<BoxPair>> found(groups.size() - 1);
  for_blocks(execution, found.size(), 1, [&](std::size_t g, std::size_t, std::size_t) {
    PairBlock own(&found[g], [](void* context, std::span<const BoxPair> pairs) {
      auto& kept = *static_cast<std::vector<BoxPair>*>(context);
      kept.insert(kept.end(), pairs.begin(), pairs.end());
    });
    sweep_group(g, own, [](std::size_t) {});
    own.flush();
  });
  for (std::size_t g = 0; g < found.size(); ++g) to.take(to.to, found[g], columns.begin[groups[g + 1]] / all);
}

}  // namespace plumb::space
