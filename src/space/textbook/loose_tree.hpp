// Loose octree, loose quadtree: a box is in the smallest cell whose loose one holds it, among those that have its
// lowest corner: of the level where it lies in no more than two cells along each axis.
//
// Laws: there are cells only where a box is, and on the way from the root to these.
// Source: RTCD 7.3.6; Ulrich, "Loose octrees", Game Programming Gems, 2000.
// Cost: a code and a look into a table of cells, and where a cell is made or given up a step for each level at most.
#pragma once

#include <algorithm>
#include <bit>

#include "space/octree/cell_keys.hpp"
#include "space/octree/seen_cells.hpp"
#include "space/textbook/level_join.hpp"
#include "space/textbook/scheme.hpp"

namespace plumb::space {

template <class Box>
class LooseTree {
 public:
  static constexpr std::size_t n = axes_of<Box>, child_count = std::size_t{1} << n;
  struct Place {
    std::uint64_t code;                // of the cell
    typename CellFrame<n>::Place low;  // of the lowest corner
    friend bool operator==(const Place& a, const Place& b) { return a.code == b.code; }
  };
  using Stored = StoredBoxes<Box, Place>;

  LooseTree(const AskedFunction& asked, const BoxStoreOptions<Box>& options)
      : frame_((require_grid_box(asked.text(), "world", options.world), options.world)), table_(16, no_cell) {
    (void)cell_at(root_code);
  }

  [[nodiscard]] const CellFrame<n>& frame() const { return frame_; }
  [[nodiscard]] Place place_of(const Box& box) const {
    const PlaceRange<n> range = range_of(frame_, box);
    std::uint32_t most = 0;
    for (std::size_t axis = 0; axis < n; ++axis) most = std::max(most, range.high[axis] - range.low[axis]);
    unsigned shift = most < 2 ? 0 : static_cast<unsigned>(std::bit_width(most)) - 1;
    const auto lies_in_two = [&] {
      for (std::size_t axis = 0; axis < n; ++axis) {
        if ((range.high[axis] >> shift) - (range.low[axis] >> shift) > 1) return false;
      }
      return true;
    };
    while (!lies_in_two()) ++shift;
    const unsigned level = CellFrame<n>::levels - shift;
    return {std::uint64_t{1} << n * level | interleaved<n>(range.low) >> n * shift, range.low};
  }

  void make_room(const AskedFunction&, std::uint32_t handle, const Place&) {
    if (handle >= links_.size()) links_.resize(std::size_t{handle} + 1);
  }
  void put(std::uint32_t handle, const Place& place) {
    const std::uint32_t cell = cell_at(place.code), behind = cells_[cell].first_item;
    links_[handle] = {cell, no_handle, behind};
    if (behind != no_handle) links_[behind].before = handle;
    cells_[cell].first_item = handle;
  }
  void take(std::uint32_t handle, const Place&) {
    const auto [cell, before, behind] = links_[handle];
    (before == no_handle ? cells_[cell].first_item : links_[before].behind) = behind;
    if (behind != no_handle) links_[behind].before = before;
  }
  /// The cell and those above it that are empty now.
  void give_up(const Place& place) {
    std::uint32_t cell = table_[slot_of(place.code)];
    while (cell != 0 && cells_[cell].first_item == no_handle && cells_[cell].used_children == 0) {
      const std::uint32_t parent = cells_[cell].parent;
      cells_[parent].children[child_number(cells_[cell].code)] = no_cell;
      --cells_[parent].used_children;
      erase_from_table(cells_[cell].code);
      free_.push_back(cell);
      cell = parent;
    }
  }

  template <class Visit>
  void visit_near(const Box& box, bool, const Stored&, const Visit& visit) const {
    const PlaceRange<n> range = range_of(frame_, box);
    struct Waiting {
      std::uint32_t cell;
      plumb::CellSpan<n> span;
    };
    std::array<Waiting, (child_count - 1) * CellFrame<n>::levels + 1> later;
    std::size_t waiting = 0;
    later[waiting++] = {0, span_of<n>(root_code)};
    while (waiting > 0) {
      const Waiting now = later[--waiting];
      for (std::uint32_t i = cells_[now.cell].first_item; i != no_handle; i = links_[i].behind) visit(i);
      for (std::size_t c = 0; c < child_count; ++c) {
        const std::uint32_t child = cells_[now.cell].children[c];
        if (child == no_cell) continue;
        const plumb::CellSpan<n> span = child_of(now.span, c), loose{span.first, 2 * span.count};
        if (range.meets(loose)) later[waiting++] = {child, span};
      }
    }
  }

  /// Levels count from the least cells up.
  static int level_of(const Place& place) {
    return static_cast<int>(CellFrame<n>::levels - plumb::level_of<n>(place.code));
  }
  static RowNumber<n> row_of(const SweptBox<Box>&, const Place& place, int level) {
    RowNumber<n> row;
    for (std::size_t axis = 1; axis < n; ++axis) row[axis - 1] = place.low[axis] >> level;
    return row;
  }

  [[nodiscard]] std::size_t parts() const { return cells_.size() - free_.size(); }
  [[nodiscard]] std::size_t memory() const {
    return cells_.capacity() * sizeof(Cell) + links_.capacity() * sizeof(Links) +
           (free_.capacity() + table_.size()) * sizeof(std::uint32_t);
  }

 private:
  static constexpr std::uint64_t root_code = 1;
  struct Cell {
    std::uint64_t code;
    std::array<std::uint32_t, child_count> children;
    std::uint32_t parent, used_children, first_item;
  };
  struct Links {
    std::uint32_t cell, before, behind;  // in the list of the cell's boxes
  };

  static std::size_t child_number(std::uint64_t code) { return static_cast<std::size_t>(code) & (child_count - 1); }

  // The table: open addressing, the next slot where one is taken.
  [[nodiscard]] std::size_t slot_of(std::uint64_t code) const {
    const std::size_t mask = table_.size() - 1;
    std::uint64_t mixed = code * 0x9e3779b97f4a7c15u;
    mixed ^= mixed >> 32;
    std::size_t slot = static_cast<std::size_t>(mixed) & mask;
    while (table_[slot] != no_cell && cells_[table_[slot]].code != code) slot = (slot + 1) & mask;
    return slot;
  }
  void grow_table() {
    const std::size_t wanted = 2 * (parts() + CellFrame<n>::levels);
    if (wanted <= table_.size()) return;
    std::vector<std::uint32_t> old(std::bit_ceil(wanted), no_cell);
    old.swap(table_);
    for (const std::uint32_t cell : old) {
      if (cell != no_cell) table_[slot_of(cells_[cell].code)] = cell;
    }
  }
  void erase_from_table(std::uint64_t code) {
    std::size_t slot = slot_of(code);
    const std::size_t mask = table_.size() - 1;
    table_[slot] = no_cell;
    // Those behind it may now be found in an earlier slot only.
    for (slot = (slot + 1) & mask; table_[slot] != no_cell; slot = (slot + 1) & mask) {
      const std::uint32_t moved = table_[slot];
      table_[slot] = no_cell;
      table_[slot_of(cells_[moved].code)] = moved;
    }
  }

  /// Made, with those on the way to it, where it is not there.
  std::uint32_t cell_at(std::uint64_t code) {
    grow_table();
    std::uint32_t below = no_cell, found = no_cell;
    for (std::uint64_t at = code; at != 0; at >>= n) {
      const std::size_t slot = slot_of(at);
      const bool is_there = table_[slot] != no_cell;
      std::uint32_t cell = table_[slot];
      if (!is_there) {
        if (free_.empty()) {
          cell = static_cast<std::uint32_t>(cells_.size());
          cells_.emplace_back();
        } else {
          cell = free_.back();
          free_.pop_back();
        }
        cells_[cell] = {at, {}, no_cell, 0, no_handle};
        cells_[cell].children.fill(no_cell);
        table_[slot] = cell;
      }
      if (below == no_cell) {
        found = cell;
      } else {
        cells_[cell].children[child_number(cells_[below].code)] = below;
        ++cells_[cell].used_children;
        cells_[below].parent = cell;
      }
      if (is_there) break;
      below = cell;
    }
    return found;
  }

  CellFrame<n> frame_;
  std::vector<Cell> cells_;
  std::vector<Links> links_;  // of each handle
  std::vector<std::uint32_t> free_;
  std::vector<std::uint32_t> table_;  // cells by their codes; no_cell where there is none
};

}  // namespace plumb::space
