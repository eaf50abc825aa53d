// Frame coherence of a sweep: which pairs of boxes overlap in one of two frames, and not in the other?
//
// Boxes stand in columns, in the order in which they start, and stay there from frame to frame.  Where few have moved,
// each of these is held against those that stand near where it was and near where it is, one after the other; where most
// have, all columns are swept, by boxes as they were and as they are.  Only pairs that differ are told: no pair is kept.
// Boxes lie in memory as they did in columns when these were planned.
// Laws: (1) lost and added are those of brute_force_pairs of both frames, by slots, ascending.  (2) Which way is taken,
// and when columns are planned anew, depends on the boxes of all frames alone, and no answer depends on it.
// Source: RTCD 7.1, 7.5.1, 7.5.2.
// Cost: a us or two for each box that moves, where few do, and more where a box is as long as the world; else some 100 ns a
// box; and some 20 ns for each pair that differs.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"
#include "space/broad_phase/column_order.hpp"
#include "space/broad_phase/frame_lanes.hpp"
#include "space/broad_phase/pair_order.hpp"
#include "space/sort_and_sweep/ordinal_map.hpp"

namespace plumb::space {

/// Of slots.  Where a slot has not changed, nobody asks what it was.
struct TwoFrames {
  std::span<const Aabb3> now, before;
  std::span<const std::uint8_t> is_there, was_there, has_changed;
  std::span<const std::uint32_t> changed;  // slots whose box is another, is new, or is gone; each once
  bool touching = true;

  [[nodiscard]] const Aabb3& was(std::uint32_t slot) const { return has_changed[slot] != 0 ? before[slot] : now[slot]; }
};

/// What was done, and what was predicted, in ns; guesses.
struct FrameWork {
  bool planned_anew = false, all_swept = false;
  double cost_of_each = 0, cost_of_all = 0;
};

class FrameSweep {
 public:
  FrameWork find(const TwoFrames& frames);

  [[nodiscard]] const std::vector<BoxPair>& lost() const { return lost_; }
  [[nodiscard]] const std::vector<BoxPair>& added() const { return added_; }

 private:
  using Column = std::vector<std::uint64_t>;  // keys: a start that is not above that of the box, place, marks
  [[nodiscard]] bool is_as_flat(const Aabb3& box) const;
  [[nodiscard]] bool is_beyond(const Aabb3& box) const;
  [[nodiscard]] bool is_outside(const OrdinalSpan& span) const;
  [[nodiscard]] StripReach reach_of(const OrdinalSpan& span) const;
  [[nodiscard]] bool is_crowd_outside() const;
  [[nodiscard]] bool is_stale() const;
  void plan_anew(const TwoFrames& frames);
  bool make_entries(const TwoFrames& frames);
  void take_over(FrameEntry& entry, const TwoFrames& frames);
  void stand_in_both(FrameEntry& entry, std::uint32_t place);
  std::size_t stand_as_now(FrameEntry& entry, std::uint32_t place);
  void put_in_columns(FrameEntry& entry, std::uint32_t place, const StripReach& reach);
  void put_left();
  template <class Work>
  std::size_t for_each_near(const OrdinalSpan& span, std::uint32_t place, const Work& work) const;
  double settle(FrameEntry& entry, std::uint32_t place, const TwoFrames& frames);
  std::size_t settle_each(const TwoFrames& frames, double most);
  void sweep_columns(const TwoFrames& frames);

  bool is_kept_ = false;
  OrdinalMap map_;
  SetBounds bounds_;               // of the map
  std::array<bool, 3> is_flat_{};  // all boxes are at one number
  bool is_any_flat_ = false;
  std::array<bool, 3> has_space_{};  // around the boxes there were, along each axis of ordinals
  double space_ = 0.0625;            // part of their extent
  std::int32_t surely_near_ = 0;     // to move by less is not to go far
  bool is_mapped_ = true;            // all boxes since, as the map says
  std::array<std::uint32_t, 2> strips_{};
  std::size_t planned_for_ = 0, copies_planned_ = 0;
  std::size_t moved_since_ = 0, far_since_ = 0;  // columns were planned
  std::uint32_t frame_ = 1;
  std::vector<FrameEntry> entries_;
  std::vector<std::int32_t> start_of_;  // of each entry, as its keys say
  std::vector<FrameEntry> left_;        // where boxes were that have moved far
  std::size_t there_ = 0, outside_ = 0, leaving_ = 0, copies_ = 0;
  std::vector<std::uint32_t> place_of_;  // of each slot
  std::vector<std::uint32_t> places_;    // of those that have changed
  std::vector<Column> columns_;
  std::vector<std::int32_t> longest_;  // in each column, from a key's start to the end of the box
  double near_each_ = 0;               // boxes with which one is compared, by the last sweep of all
  Column keys_;
  ColumnOrder order_;
  SweptEntries swept_;
  std::vector<BoxPair> lost_, added_, other_;
};

}  // namespace plumb::space
