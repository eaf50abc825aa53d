// Frame coherence of a sweep: which pairs of boxes overlap in one of two frames, and not in the other?
//
// Swept columns of boxes as they were and as they are, of which only pairs that differ are told: no pair is kept.  Which
// boxes stand in a column, and in which order, is kept from frame to frame, so that columns are nearly sorted; boxes lie
// in memory as they did in columns when these were planned.  A box that has moved far stands in columns twice, where it
// was and where it is.
// Laws: (1) lost and added are those of brute_force_pairs of both frames, by slots, ascending.  (2) When columns are
// planned anew depends on the boxes of all frames alone, and no answer depends on it.
// Source: RTCD 7.1, 7.5.1, 7.5.2.
// Cost: some 70 ns a box, and some 20 ns for each pair that differs.
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

/// Of slots.  Where a slot has not moved, or was none, nobody asks what it was.
struct TwoFrames {
  std::span<const Aabb3> now, before;
  std::span<const std::uint8_t> is_there, was_there, has_moved;
  bool touching = true;

  [[nodiscard]] const Aabb3& was(std::uint32_t slot) const { return has_moved[slot] != 0 ? before[slot] : now[slot]; }
};

class FrameSweep {
 public:
  /// The box of a slot is another since the last frame, or is new; or it is gone.
  void note(std::uint32_t slot, const Aabb3& box);
  void note_removed(std::uint32_t slot);
  /// That will be noted soon.
  void prefetch(std::uint32_t slot) const {
    if (is_kept_) __builtin_prefetch(&entries_[place_of_[slot]], 1);
  }

  /// Of all that was noted, which begins where the last frame ended.
  void find(const TwoFrames& frames);

  [[nodiscard]] const std::vector<BoxPair>& lost() const { return lost_; }
  [[nodiscard]] const std::vector<BoxPair>& added() const { return added_; }
  /// Half of a box as long as the mean along each axis; a guess, of when columns were planned.
  [[nodiscard]] const Vector3& half_mean() const { return half_mean_; }

  /// Memory is given back, and nothing is known of frames before.
  void clear() { *this = {}; }

 private:
  struct InColumn {
    std::uint32_t column, place;
  };
  [[nodiscard]] bool is_as_flat(const Aabb3& box) const;
  [[nodiscard]] bool is_inside(const OrdinalSpan& span) const;
  [[nodiscard]] StripReach reach_of(const FrameEntry& entry) const;
  [[nodiscard]] std::uint32_t place_for(std::uint32_t slot);
  template <class Change>
  void change(std::uint32_t slot, const Change& change);
  void plan_anew(const TwoFrames& frames);
  bool make_entries(const TwoFrames& frames);
  void leave_if_far(FrameEntry& entry);
  void put_in_columns(FrameEntry& entry, std::uint32_t place, const StripReach& reach);
  void put_left();
  [[nodiscard]] bool is_stale() const;
  void order_incoming();
  void sweep_columns(const TwoFrames& frames);

  bool is_kept_ = false;
  OrdinalMap map_;
  SetBounds bounds_;                              // of the map
  std::array<bool, 3> is_flat_{};                 // all boxes are at one number
  bool has_space_ = false, is_any_flat_ = false;  // has space around the boxes there were
  std::int32_t surely_near_ = 0;                  // to move by less is not to go far
  bool is_mapped_ = true;                         // all boxes since, as the map says
  std::array<std::uint32_t, 2> strips_{};
  std::size_t planned_for_ = 0, frames_ = 0, copies_planned_ = 0;
  Vector3 half_mean_{};
  std::uint32_t frame_ = 1;
  bool is_any_again_ = false;  // noted twice in this frame
  std::vector<FrameEntry> entries_;
  std::vector<FrameEntry> left_;  // where boxes were that have moved far
  std::size_t there_ = 0, copies_ = 0;
  std::vector<std::uint32_t> place_of_;                // of each slot
  std::vector<std::uint32_t> listed_, listed_before_;  // places by columns, in the order of the last sweep
  std::vector<std::uint32_t> end_, end_before_;        // of each column
  std::vector<InColumn> incoming_, incoming_unordered_;
  std::vector<std::uint32_t> end_incoming_;
  std::vector<std::uint64_t> keys_;
  ColumnOrder order_;
  SweptEntries swept_;
  std::vector<BoxPair> lost_, added_, other_;
};

}  // namespace plumb::space
