// Sort and sweep (sweep and prune) for coherent motion: boxes that move little keep nearly the same order along an axis.
//
//   SweepArray sweep;
//   for (each frame) use(sweep.overlapping_pairs(boxes));      // the same boxes, moved
//   sweep.steps()                                  // of the insertion sort in the last frame
//
// Laws: (1) pairs(boxes) are those of sort_and_sweep_pairs along the same axis, in the same order, whatever came before.
// (2) The axis is that of greatest variance; where it changes, the number of boxes does, or the insertion sort has taken
// more steps than a radix sort costs, boxes are sorted from scratch.
// A number that is NaN or infinite throws NonFinite, a box that is empty InvalidShape, and the order is kept.
// Source: RTCD 7.5.2.
// Cost: some ns a box for the order, and the sweep (sort_and_sweep.hpp).  Bounded by n^2 comparisons a call.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "plumb/space/sort_and_sweep/sort_and_sweep.hpp"

namespace plumb {

struct SweepArrayOptions {
  bool touching = true;  // false: only the pairs that overlap
};

class SweepArray {
 public:
  explicit SweepArray(const SweepArrayOptions& options = {});
  SweepArray(SweepArray&&) noexcept;
  SweepArray& operator=(SweepArray&&) noexcept;
  ~SweepArray();

  /// Valid until the next call.
  const std::vector<BoxPair>& overlapping_pairs(std::span<const Aabb3> boxes);

  [[nodiscard]] SweepAxis axis() const;
  [[nodiscard]] std::size_t steps() const;
  /// Was the last order made from scratch?
  [[nodiscard]] bool from_scratch() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace plumb
