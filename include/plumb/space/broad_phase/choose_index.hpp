// Which spatial index for these boxes?  What each method of the broad phase is expected to take, and what it takes.
//
//   const IndexChoice choice = choose_index(boxes);
//   overlapping_pairs(boxes, {.method = choice.best().method});
//   choose_index(boxes, {.moving_share = 0.1, .measure = true})     // of frames in which a tenth moves; run as well
//
// A method is taken from scratch each time, or its structure is kept from frame to frame, in space, and what moves is
// moved in it: MovingBoxes (swept_columns), SweepArray (sort_and_sweep).  The structures of textbook/box_store.hpp, which
// are never the fastest, are no candidates.
// Laws: (1) traits and predictions depend on the numbers of the boxes and on moving_share alone.  (2) A prediction is a
// guess: sums of what was counted in a sample of 512 boxes, each times a cost that was measured once, on one machine
// (src/space/broad_phase/index_costs.cpp says which).  No answer depends on it: every method finds the same pairs.
// (3) costs ascend by what is predicted, and name each candidate once from scratch and at most once kept.
// A prediction is within a half of what was measured as a rule, and one in ten is off by a factor of 2 to 7.
// To let the automatic method choose needs none of this: it is the fastest as measured on machines like that one.
// A moving_share that is not from 0 to 1 and empty boxes throw InvalidShape, NaN and infinity NonFinite.
// Source: RTCD 2.4.1.
// Cost: some passes over the boxes and some 2 ms; to measure, up to most_milliseconds and what is made before for each
// method that is predicted to take no longer.  Bounded by n log n operations for n boxes, where nothing is measured.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "plumb/space/broad_phase/overlapping_pairs.hpp"

namespace plumb {

struct ChooseIndexOptions {
  double moving_share = 0;         // of the boxes, from one frame to the next; 0: asked once
  bool measure = false;            // run the methods, each on the thread that asks
  double most_milliseconds = 200;  // methods that are predicted to take longer are not run
};

/// As a sample of at most 512 boxes says.
struct BoxTraits {
  std::size_t count = 0;    // all
  int dimensions = 0;       // 2 or 3
  double pairs = 0;         // that overlap, for each box
  double size_ratio = 1;    // of large boxes to small ones: of the longest edges that 5 of 100 are above, and below
  double clustering = 1;    // how many times as many boxes near a box as if all were spread evenly
  double moving_share = 0;  // as was told
};

struct IndexCost {
  BroadPhaseMethod method = BroadPhaseMethod::automatic;
  bool is_kept = false;            // from frame to frame
  double predicted = 0;            // ns a box and frame
  std::optional<double> measured;  // the same, where it was run
};

struct IndexChoice {
  BoxTraits traits;
  std::vector<IndexCost> costs;  // ascending by what is predicted

  /// By prediction.
  [[nodiscard]] const IndexCost& best() const { return costs.front(); }
  /// By measurement; nothing where none was run.
  [[nodiscard]] std::optional<IndexCost> fastest() const;
};

IndexChoice choose_index(std::span<const Aabb2> boxes, const ChooseIndexOptions& options = {});
IndexChoice choose_index(std::span<const Aabb3> boxes, const ChooseIndexOptions& options = {});

}  // namespace plumb
