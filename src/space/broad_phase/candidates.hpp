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

/// Boxes by their places: those that lie near each other have places that do.
struct Candidate {
  std::uint32_t a, b;
};

class Candidates {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  /// Of the boxes in these slots, all anew.
  void make_anew(std::span<const Aabb3> boxes, std::span<const std::uint32_t> slots, double margin);

  /// Is the box still in its fat one?  Keeps its ordinals.
  bool move_to(std::uint32_t slot, const Aabb3& box);
  /// No longer a candidate with any, and without a fat box.
  void drop(std::uint32_t slot);
  /// Another fat box around where it is, and its candidates.
  void place(std::uint32_t slot, const Aabb3& box);

  /// Do the boxes of a candidate overlap?  Ordinals say, or else the numbers.
  [[nodiscard]] bool do_meet(const Candidate& c, std::span<const Aabb3> boxes, bool touching) const {
    const OrdinalBox &a = now_[c.a], &b = now_[c.b];
    const Four a_low = four_from(a, 0), a_high = four_from(a, 3), b_low = four_from(b, 0), b_high = four_from(b, 3);
    const Four apart = (a_low > b_high) | (b_low > a_high), equal = (a_low == b_high) | (b_low == a_high);
    const bool is_apart = (apart[0] | apart[1] | apart[2]) != 0;
    if ((equal[0] | equal[1] | equal[2]) == 0) [[likely]]
      return !is_apart;
    return !is_apart && boxes_meet(boxes[slot_of_[c.a]], boxes[slot_of_[c.b]], touching);
  }

  /// Does it reach beyond the space that ordinals tell apart?  What does has candidates of all else that does.
  [[nodiscard]] bool is_outside(const Aabb3& box) const {
    const auto x = numbers_of(box);
    bool outside = false;
    for (std::size_t k = 0; k < 3; ++k) outside |= x[k] < bounds_.min[k] || x[k + 3] > bounds_.max[k];
    return outside;
  }
  /// Boxes that were placed although they do.
  [[nodiscard]] std::size_t outside() const { return outside_; }
  /// Nothing can be placed where no box has ever been.
  [[nodiscard]] bool is_made() const { return has_map_; }
  [[nodiscard]] std::size_t size() const { return all_.size() - dropped_; }
  [[nodiscard]] std::size_t dropped() const { return dropped_; }
  /// Those that were dropped among them.
  [[nodiscard]] std::span<const Candidate> all() const { return all_; }
  std::vector<Met>& met() { return met_; }
  [[nodiscard]] const std::vector<Met>& met() const { return met_; }
  [[nodiscard]] std::uint32_t slot_of(std::uint32_t place) const { return slot_of_[place]; }

  /// work(number, candidate) for each of a slot that is not dropped.
  template <class Work>
  void for_each_of(std::uint32_t slot, const Work& work) const {
    const std::uint32_t own = slot < place_of_.size() ? place_of_[slot] : none;
    if (own == none) return;
    if (is_listed_[own] != 0) {
      for (std::uint32_t i = listed_from_[own]; i < listed_from_[own + 1]; ++i) {
        if (met_[listed_[i].number] != Met::dropped) work(listed_[i].number, Candidate{own, listed_[i].other});
      }
    }
    for (std::uint32_t c = first_added_[own]; c != none;) {
      const std::uint32_t now = c;
      c = next_added_[now - made_][all_[now].a == own ? 0 : 1];
      if (met_[now] != Met::dropped) work(now, all_[now]);
    }
  }

 private:
  // Three ordinals, and what comes after them.
  using Four = std::int32_t __attribute__((vector_size(16)));
  static Four four_from(const OrdinalBox& box, std::size_t number) {
    Four four;
    __builtin_memcpy(&four, reinterpret_cast<const char*>(&box) + number * sizeof(std::int32_t), sizeof four);
    return four;
  }
  void add(std::uint32_t a, std::uint32_t b);
  void list_made();
  [[nodiscard]] OrdinalBox fattened(OrdinalBox box) const;
  std::uint32_t place_for(std::uint32_t slot);

  // A fat box in a column is one of now where its serial (marks / 4) is that of its place.
  [[nodiscard]] bool is_current(const OrdinalBox& fat) const {
    return static_cast<std::uint32_t>(fat.marks) >> 2 == serial_[static_cast<std::size_t>(fat.number)];
  }

  OrdinalMap map_;
  SetBounds bounds_;
  std::size_t outside_ = 0;
  bool has_map_ = false;
  std::array<std::int32_t, 3> margin_{};  // in ordinals
  std::vector<std::uint32_t> place_of_;   // of each slot
  // Of each place:
  std::vector<std::uint32_t> slot_of_, serial_;
  std::vector<OrdinalBox> fat_, now_;
  std::vector<std::uint8_t> has_fat_, is_listed_;
  std::vector<std::uint32_t> first_added_;

  std::vector<Candidate> all_;
  std::vector<Met> met_;
  std::size_t dropped_ = 0;
  std::uint32_t made_ = 0;  // candidates that were made together; then come those that were added one at a time
  std::vector<std::array<std::uint32_t, 2>> next_added_;  // of a, and of b
  struct Listed {
    std::uint32_t other, number;
  };
  std::vector<std::uint32_t> listed_from_;  // of those made together, for each place
  std::vector<Listed> listed_;

  std::array<std::uint32_t, 2> strips_{1, 1};
  Columns columns_;
  std::vector<std::int32_t> longest_;            // fat box along each column
  std::vector<std::vector<OrdinalBox>> placed_;  // in each column since
};

}  // namespace plumb::space
