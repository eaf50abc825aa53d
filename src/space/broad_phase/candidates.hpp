// Candidates: pairs of fat boxes, which stay the same while boxes move within theirs.
//
// Laws: (1) two boxes that stand within their fat boxes and overlap are a candidate.  (2) A candidate `met` where the
// boxes overlapped when it was last asked.
#pragma once

#include <memory>
#include <vector>

#include "space/broad_phase/columns.hpp"
#include "space/sort_and_sweep/ordinal_map.hpp"

namespace plumb::space {

enum class Met : std::uint8_t { no, yes, dropped };

struct Candidate {
  static constexpr std::uint32_t none = 0xffffffff;
  std::uint32_t a, b;            // slots
  std::uint32_t next_a, next_b;  // the candidates of a and of b, one after the other
};

class Candidates {
 public:
  /// Of the boxes in these slots, all anew.
  void make_anew(std::span<const Aabb3> boxes, std::span<const std::uint32_t> slots, double margin);

  /// Is the box still in its fat one?  Keeps its ordinals.
  bool move_to(std::uint32_t slot, const Aabb3& box);
  /// No longer a candidate with any, and without a fat box.
  void drop(std::uint32_t slot);
  /// Another fat box around where it is, and its candidates.
  void place(std::uint32_t slot);

  /// Do the boxes of a candidate overlap?  Ordinals say, or else the numbers.
  [[nodiscard]] bool do_meet(const Candidate& c, std::span<const Aabb3> boxes, bool touching) const;

  /// Nothing can be placed where no box has ever been.
  [[nodiscard]] bool is_made() const { return has_map_; }
  [[nodiscard]] std::size_t size() const { return all_.size() - dropped_; }
  [[nodiscard]] std::size_t dropped() const { return dropped_; }
  /// Those that were dropped among them.
  [[nodiscard]] std::span<const Candidate> all() const { return all_; }
  std::vector<Met>& met() { return met_; }
  [[nodiscard]] const std::vector<Met>& met() const { return met_; }

  /// work(candidate's number) for each of a slot that is not dropped.
  template <class Work>
  void for_each_of(std::uint32_t slot, const Work& work) const {
    if (slot >= first_.size()) return;
    for (std::uint32_t c = first_[slot]; c != Candidate::none;) {
      const Candidate& candidate = all_[c];
      const std::uint32_t next = candidate.a == slot ? candidate.next_a : candidate.next_b;
      if (met_[c] != Met::dropped) work(c);
      c = next;
    }
  }

 private:
  void add(std::uint32_t a, std::uint32_t b);
  [[nodiscard]] OrdinalBox fattened(OrdinalBox box) const;
  void grow_to(std::size_t slots);

  // A fat box in a column is one of now where its serial (marks / 4) is that of its slot.
  [[nodiscard]] bool is_current(const OrdinalBox& fat) const {
    return static_cast<std::uint32_t>(fat.marks) >> 2 == serial_[static_cast<std::size_t>(fat.number)];
  }

  OrdinalMap map_;
  bool has_map_ = false;
  std::array<std::int32_t, 3> margin_{};  // in ordinals
  std::vector<OrdinalBox> fat_, now_;     // of each slot
  std::vector<std::uint32_t> serial_;     // of the slot's fat box
  std::vector<std::uint8_t> has_fat_;
  std::vector<std::uint32_t> first_;  // candidate of each slot
  std::vector<Candidate> all_;
  std::vector<Met> met_;
  std::size_t dropped_ = 0;
  std::array<std::uint32_t, 2> strips_{1, 1};
  Columns columns_;
  std::vector<std::int32_t> longest_;            // fat box along each column
  std::vector<std::vector<OrdinalBox>> placed_;  // in each column since
};

}  // namespace plumb::space
