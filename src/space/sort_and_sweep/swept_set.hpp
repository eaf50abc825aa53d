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

/// Pairs that are told as they are found; `done` is the part of the work that is done.
class StreamedPairs {
 public:
  explicit StreamedPairs(const PairTaker& to)
      : to_(to), block_(this, [](void* self, std::span<const BoxPair> pairs) {
          const auto& streamed = *static_cast<const StreamedPairs*>(self);
          streamed.to_.take(streamed.to_.to, pairs, streamed.done);
        }) {}
  StreamedPairs(const StreamedPairs&) = delete;
  StreamedPairs& operator=(const StreamedPairs&) = delete;

  double done = 0;
  PairBlock& block() { return block_; }

 private:
  const PairTaker& to_;
  PairBlock block_;
};

/// Pairs that are kept until it is their turn.
inline PairBlock kept_in(std::vector<BoxPair>& kept) {
  return {&kept, [](void* to, std::span<const BoxPair> pairs) {
            auto& vector = *static_cast<std::vector<BoxPair>*>(to);
            vector.insert(vector.end(), pairs.begin(), pairs.end());
          }};
}

/// Few boxes are swept at a time, so that their pairs, if each meets all, take little memory; few parts of the work are
/// done at once, and of each few pairs kept: the rest is found anew when it is told.
inline constexpr std::size_t boxes_at_once = 16, most_kept = std::size_t{1} << 21, parts_at_once = 32;

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

/// The first of so many axes along which lists are kept, the others being those after it; in the plane both from x on.
template <class Box>
std::size_t first_listed_axis(const BoxSet<Box>& set, const SetBounds& bounds, std::size_t lists) {
  return axes_of<Box> == 2 && lists > 1 ? 0 : widest_axis(set, bounds);
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
  const auto part_done = [n](std::size_t i) { return static_cast<double>(i) / static_cast<double>(n - 1); };
  // As long as goes_on(boxes that are swept); how far it came.
  const auto sweep_while = [&](std::size_t from, std::size_t until, PairBlock& block, auto&& goes_on) {
    while (from < until) {
      const std::size_t end = std::min(from + boxes_at_once, until);
      sweep(swept, from, end, decide, block);
      from = end;
      if (!goes_on(from)) break;
    }
    return from;
  };
  StreamedPairs streamed(to);
  const auto tell_rest = [&](std::size_t from, std::size_t until) {
    streamed.done = std::max(streamed.done, part_done(from));
    sweep_while(from, until, streamed.block(), [&](std::size_t i) {
      streamed.done = part_done(i);
      return true;
    });
    streamed.block().flush();
  };
  if (execution == Execution::serial) return tell_rest(0, n - 1);
  for (std::size_t first = 0; first < n - 1; first += parts_at_once * block_size) {
    const std::size_t end = std::min(n - 1, first + parts_at_once * block_size);
    std::vector<std::vector<BoxPair>> found(blocks_of(end - first, block_size));
    std::vector<std::size_t> stopped(found.size());
    for_blocks(execution, end - first, block_size, [&](std::size_t b, std::size_t from, std::size_t until) {
      PairBlock block = kept_in(found[b]);
      stopped[b] =
          sweep_while(first + from, first + until, block, [&](std::size_t) { return found[b].size() <= most_kept; });
      block.flush();
    });
    for (std::size_t b = 0; b < found.size(); ++b) {
      to.take(to.to, found[b], part_done(stopped[b]));
      found[b] = {};
      tell_rest(stopped[b], std::min(end, first + (b + 1) * block_size));
    }
  }
}

}  // namespace plumb::space
