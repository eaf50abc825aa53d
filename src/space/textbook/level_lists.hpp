// Hierarchical grid, hashed: levels of cells twice as large each, a box in the list of the cell that holds its min.
//
// What overlaps a box at its own and higher levels is in the lists of at most three cells along each axis.  Levels
// without a box cost nothing.
// Source: RTCD 7.2.1.
#pragma once

#include "space/textbook/levels.hpp"

namespace plumb::space {

template <class Box>
class LevelLists : public GridLevels<Box> {
 public:
  using GridLevels<Box>::n;
  struct Place {
    int level;
    CellNumber<n> cell;  // that holds its min
    friend bool operator==(const Place&, const Place&) = default;
  };
  using Stored = StoredBoxes<Box, Place>;

  LevelLists(const AskedFunction& asked, const BoxStoreOptions<Box>& options)
      : GridLevels<Box>(asked, options.least_level) {
    heads_.assign(least_places, no_handle);
  }

  [[nodiscard]] Place place_of(const Box& box) const {
    const auto [level, span] = this->place_in(box);
    return {level, span.first};
  }

  /// Twice as many lists as there are boxes, or nearly so.
  void make_room(const AskedFunction&, std::uint32_t handle, const Place&) {
    if (handle >= links_.size()) links_.resize(std::size_t{handle} + 1);
    if (size_ < heads_.size() / 2) return;
    std::vector<std::uint32_t> old(heads_.size() * 4, no_handle);
    old.swap(heads_);
    for (std::uint32_t head : old) {
      while (head != no_handle) {
        const std::uint32_t next = links_[head].next;
        link(head);
        head = next;
      }
    }
  }

  void put(std::uint32_t handle, const Place& place) {
    links_[handle].place = place;
    link(handle);
    ++size_;
    const auto at = level_at(levels_, place.level);
    if (at == levels_.end() || at->level != place.level) {
      levels_.insert(at, {place.level, 1});
    } else {
      ++at->boxes;
    }
  }
  void take(std::uint32_t handle, const Place& place) {
    const Links& links = links_[handle];
    if (links.next != no_handle) links_[links.next].previous = links.previous;
    (links.previous != no_handle ? links_[links.previous].next : heads_[slot_of(links.place)]) = links.next;
    --size_;
    const auto at = level_at(levels_, place.level);
    if (--at->boxes == 0) levels_.erase(at);
  }

  /// A box is told by its first cell, and reaches no farther than the next.
  template <class Visit>
  void visit_near(const Box& box, bool, const Stored& stored, const Visit& visit) const {
    const auto cells_at = [&](const Level& l) {
      CellSpan<n> span = cells_of(box, per_level_size(l.level));
      for (std::int32_t& x : span.first) --x;
      return span;
    };
    double cells = 0;
    for (const Level& l : levels_) cells += cell_count(cells_at(l));
    if (cells > static_cast<double>(links_.size())) {  // more cells than boxes
      for (std::uint32_t b = 0; b < stored.boxes.numbers(); ++b) {
        if (stored.boxes.contains(b)) visit(b);
      }
      return;
    }
    for (const Level& l : levels_) {
      for_cells(cells_at(l), [&](const auto& cell) {
        const Place place{l.level, cell};
        for (std::uint32_t i = heads_[slot_of(place)]; i != no_handle; i = links_[i].next) {
          if (links_[i].place == place) visit(i);
        }
      });
    }
  }

  [[nodiscard]] std::size_t parts() const { return levels_.size(); }
  [[nodiscard]] std::size_t memory() const {
    return links_.capacity() * sizeof(Links) + heads_.size() * sizeof(std::uint32_t) +
           levels_.capacity() * sizeof(Level);
  }

 private:
  struct Links {
    Place place;
    std::uint32_t next, previous;  // in the list
  };
  struct Level {
    int level;
    std::size_t boxes;
  };

  [[nodiscard]] std::size_t slot_of(const Place& at) const {
    return (hash_of(at.cell) + static_cast<std::uint64_t>(at.level + 1100) * 0x9FB21C651E98DF25u) & (heads_.size() - 1);
  }
  void link(std::uint32_t handle) {
    std::uint32_t& head = heads_[slot_of(links_[handle].place)];
    links_[handle].next = head, links_[handle].previous = no_handle;
    if (head != no_handle) links_[head].previous = handle;
    head = handle;
  }

  std::vector<Links> links_;          // of each handle
  std::vector<std::uint32_t> heads_;  // the first of each list
  std::vector<Level> levels_;         // that have a box, ascending
  std::size_t size_ = 0;
};

}  // namespace plumb::space
