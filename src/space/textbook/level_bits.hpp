// Hierarchical grid of rows and columns: each level has the bits of an implicit grid, in slots of the boxes at it.
//
// A box sets two bits along each axis at most.  Nothing is hashed, and what a large box overlaps of a lower level is
// found by rows, not cell by cell.
// Source: RTCD 7.2.2.
#pragma once

#include "space/textbook/bit_cells.hpp"
#include "space/textbook/levels.hpp"

namespace plumb::space {

template <class Box>
class LevelBits : public GridLevels<Box> {
 public:
  using GridLevels<Box>::n;
  using Place = PlaceInLevels<n>;
  using Stored = StoredBoxes<Box, Place>;

  LevelBits(const AskedFunction& asked, const BoxStoreOptions<Box>& options)
      : GridLevels<Box>(asked, options.least_level),
        rows_(checked_rows(asked, options.rows)),
        most_memory_(options.most_memory) {}

  [[nodiscard]] Place place_of(const Box& box) const { return this->place_in(box); }

  void make_room(const AskedFunction& asked, std::uint32_t handle, const Place& place) {
    if (handle >= slots_.size()) slots_.resize(std::size_t{handle} + 1);
    auto at = level_at(levels_, place.level);
    const bool is_new = at == levels_.end() || at->level != place.level;
    if (!is_new && (!at->free.empty() || at->handles.size() < at->rows.slots())) return;
    const std::size_t slots = is_new ? 64 : 2 * at->rows.slots();
    double bytes = BitRows<n>::memory_of(rows_, slots);
    for (const Level& l : levels_) bytes += static_cast<double>(l.rows.memory());
    asked.require_memory(bytes, most_memory_, "choose fewer rows");
    if (is_new) at = levels_.insert(at, Level{place.level, BitRows<n>(rows_), {}, {}});
    at->rows.reserve(slots);
  }
  void put(std::uint32_t handle, const Place& place) {
    Level& level = *level_at(levels_, place.level);
    auto slot = static_cast<std::uint32_t>(level.handles.size());
    if (level.free.empty()) {
      level.handles.push_back(handle);
    } else {
      slot = level.free.back();
      level.free.pop_back();
      level.handles[slot] = handle;
    }
    level.rows.set(slot, place.span, true);
    slots_[handle] = slot;
  }
  void take(std::uint32_t handle, const Place& place) {
    Level& level = *level_at(levels_, place.level);
    level.rows.set(slots_[handle], place.span, false);
    level.free.push_back(slots_[handle]);
  }

  template <class Visit>
  void visit_near(const Box& box, bool, const Stored&, const Visit& visit) const {
    std::vector<std::uint64_t> both, one;
    for (const Level& l : levels_) {
      l.rows.for_common(cells_of(box, per_level_size(l.level)), 0, l.handles.size(), both, one,
                        [&](std::size_t slot) { visit(l.handles[slot]); });
    }
  }

  [[nodiscard]] std::size_t parts() const {
    return static_cast<std::size_t>(
        std::count_if(levels_.begin(), levels_.end(), [](const Level& l) { return l.free.size() < l.handles.size(); }));
  }
  [[nodiscard]] std::size_t memory() const {
    std::size_t bytes = slots_.capacity() * sizeof(std::uint32_t);
    for (const Level& l : levels_) {
      bytes += l.rows.memory() + (l.handles.capacity() + l.free.capacity()) * sizeof(std::uint32_t);
    }
    return bytes;
  }

 private:
  struct Level {
    int level;
    BitRows<n> rows;
    std::vector<std::uint32_t> handles;  // of the slots
    std::vector<std::uint32_t> free;     // slots
  };

  std::size_t rows_, most_memory_;
  std::vector<std::uint32_t> slots_;  // of each handle, at its level
  std::vector<Level> levels_;         // ascending
};

}  // namespace plumb::space
