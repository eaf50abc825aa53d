// Boxes in columns, each swept along its length: which overlap?
//
// Law: the order of pairs depends on the boxes and `touching` alone.
// Source: RTCD 7.1, 7.5.2.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "space/broad_phase/column_order.hpp"
#include "space/broad_phase/columns.hpp"
#include "space/broad_phase/sweep_plan.hpp"
#include "space/bvh/parts.hpp"
#include "space/sort_and_sweep/swept_set.hpp"

namespace plumb::space {

/// What the automatic method takes of n boxes, as measured: to choose columns takes longer than to sweep up to a
/// thousand along one axis.
constexpr BroadPhaseMethod method_taken(BroadPhaseMethod asked, std::size_t n) {
  constexpr std::size_t few_boxes = 48, some_boxes = 1000;
  if (asked != BroadPhaseMethod::automatic) return asked;
  return n <= few_boxes    ? BroadPhaseMethod::brute_force
         : n <= some_boxes ? BroadPhaseMethod::sort_and_sweep
                           : BroadPhaseMethod::swept_columns;
}

/// Where the boxes are placed, and along which columns they are swept.
struct PlacedSweep {
  OrdinalMap map;
  SweepPlan plan;
};

/// By a sample of the boxes; a guess.
template <class Box>
PlacedSweep place_sweep(const BoxSet<Box>& set, const SetBounds& bounds) {
  constexpr std::size_t axes = axes_of<Box>;
  constexpr std::size_t one_of = 32, least = 64, most = 256;  // guesses of how large a sample serves
  constexpr float small = 0x1p-30F;                           // a power of two: ordinals as floats near 1
  const std::size_t n = set.size(), m = std::min(n, std::clamp<std::size_t>(n / one_of, least, most));
  const std::array<int, 3> all_bits{ordinal_bits, ordinal_bits, ordinal_bits};
  const auto plan_by = [&](const OrdinalMap& map) {
    std::vector<SampledBox> sample(m);  // guesses, by which columns are chosen and nothing is decided
    for (std::size_t i = 0; i < m; ++i) {
      const OrdinalBox b = map(set[i * n / m], 0, 0);
      for (std::size_t k = 0; k < 3; ++k) {
        sample[i].low[k] = static_cast<float>(b.low[k]) * small;
        sample[i].high[k] = static_cast<float>(b.high[k]) * small;
      }
    }
    return plan_sweep(sample, n);
  };
  const SweepPlan plan = plan_by(OrdinalMap(bounds, {0, 1, 2}, all_bits));
  constexpr double many = 64, gain = 0.25;  // comparisons of a box that are worth a second look, and fewer of them
  if (plan.windows < many * static_cast<double>(n)) return {OrdinalMap(bounds, plan.order, all_bits), plan};
  std::array<std::vector<double>, 3> knots;
  for (std::size_t i = 0; i < m; ++i) {
    const auto x = numbers_of(set[i * n / m]);
    for (std::size_t k = 0; k < axes; ++k) knots[k].push_back(x[k]), knots[k].push_back(x[k + axes]);
  }
  const SweepPlan other = plan_by(OrdinalMap(bounds, {0, 1, 2}, all_bits, knots));
  if (other.windows > gain * plan.windows) return {OrdinalMap(bounds, plan.order, all_bits), plan};
  return {OrdinalMap(bounds, other.order, all_bits, knots), other};
}

/// In the order of the set.
template <class Box>
std::unique_ptr<OrdinalBox[]> ordinals_of(Execution execution, const BoxSet<Box>& set, const OrdinalMap& map) {
  constexpr std::size_t block_size = 1 << 15;
  const std::size_t n = set.size(), of_a = set.a.size();
  auto ordinals = std::make_unique_for_overwrite<OrdinalBox[]>(n);
  const std::int32_t mark_of_a = set.b.empty() ? 0 : of_first_set;
  for_blocks(execution, n, block_size, [&](std::size_t, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < std::min(to, of_a); ++i) ordinals[i] = map(set.a[i], i, mark_of_a);
    for (std::size_t i = std::max(from, of_a); i < to; ++i) ordinals[i] = map(set.b[i - of_a], i, of_second_set);
  });
  return ordinals;
}

/// Columns whose boxes are many enough to be one thread's next work.
std::vector<std::size_t> groups_of(const Columns& columns);

/// How far a sweep is: a column, and a box in its order.
struct SweptPlace {
  std::size_t column = 0, box = 0;
};

/// Of boxes that are checked and have these bounds.  However many pairs there are, few are kept at a time.
template <class Box>
void find_by_columns(Execution execution, const BoxSet<Box>& set, const SetBounds& bounds, const PairTaker& to) {
  const std::size_t n = set.size();
  auto [map, plan] = place_sweep(set, bounds);
  auto ordinals = ordinals_of(execution, set, map);
  const Columns columns = divide_into_columns(execution, {ordinals.get(), n}, plan.columns);
  ordinals.reset();
  const DecidePair decide{&set, &decide_of_set<Box>};
  const std::vector<std::size_t> groups = groups_of(columns);
  const auto all = static_cast<double>(columns.begin.back());
  // From a box of a column on, as long as goes_on(column, boxes of it that are swept).
  const auto sweep_group = [&](std::size_t g, SweptPlace from, PairBlock& block, auto&& goes_on) {
    SweptBoxes swept;
    ColumnOrder order;
    for (std::size_t c = std::max(from.column, groups[g]); c < groups[g + 1]; ++c) {
      if (columns[c].size() < 2) continue;
      swept.assign(columns[c], order(columns[c]));
      for (std::size_t i = c == from.column ? from.box : 0; i + 1 < swept.size();) {
        const std::size_t end = std::min(i + boxes_at_once, swept.size() - 1);
        sweep(swept, i, end, decide, block);
        i = end;
        if (!goes_on(SweptPlace{c, i})) return;
      }
    }
  };
  const auto done_at = [&](const SweptPlace& at) {
    return (columns.begin[at.column] + static_cast<double>(at.box)) / all;
  };
  StreamedPairs streamed(to);
  const auto tell_rest = [&](std::size_t g, const SweptPlace& from) {
    streamed.done = std::max(streamed.done, done_at(from));
    sweep_group(g, from, streamed.block(), [&](const SweptPlace& at) {
      streamed.done = done_at(at);
      return true;
    });
    streamed.block().flush();
  };
  const std::size_t count = groups.size() - 1;
  if (execution == Execution::serial || count <= 1) {
    for (std::size_t g = 0; g < count; ++g) tell_rest(g, {});
    return;
  }
  for (std::size_t first = 0; first < count; first += parts_at_once) {
    std::vector<std::vector<BoxPair>> found(std::min(parts_at_once, count - first));
    std::vector<std::optional<SweptPlace>> stopped(found.size());
    for_blocks(execution, found.size(), 1, [&](std::size_t g, std::size_t, std::size_t) {
      PairBlock own = kept_in(found[g]);
      sweep_group(first + g, {}, own, [&](const SweptPlace& at) {
        if (found[g].size() <= most_kept) return true;
        stopped[g] = at;
        return false;
      });
      own.flush();
    });
    for (std::size_t g = 0; g < found.size(); ++g) {
      to.take(to.to, found[g], stopped[g] ? done_at(*stopped[g]) : columns.begin[groups[first + g + 1]] / all);
      found[g] = {};
      if (stopped[g]) tell_rest(first + g, *stopped[g]);
    }
  }
}

}  // namespace plumb::space
