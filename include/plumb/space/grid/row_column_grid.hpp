// Broad phase (hierarchical grid of rows and columns): which boxes overlap, whatever their sizes?  Each level keeps
// bits of its rows, columns and layers instead of cells.
//
//   RowColumnGrid3 grid;
//   const std::uint32_t handle = grid.insert(box);
//   grid.move(handle, other);   grid.remove(handle);
//   grid.overlapping_pairs();   grid.in_box(box);
//
// Levels are those of hierarchical_grid.hpp; at each there is an implicit grid (implicit_grid.hpp) of the boxes that
// are at it.  A box sets two bits along each axis at most.  Nothing is hashed, and what a large box overlaps of a
// lower level is found by rows, not cell by cell.
// Laws: those of list_grid.hpp; pairs ascend by a, then b.
// Errors are those of implicit_grid.hpp.
// Source: RTCD 7.2.2.
// Cost: insert, move and remove take constant time; a query a 64th of an operation for each box and row of each level;
// pairs as of hierarchical_grid.hpp, which asks no bits.  Bounded by n^2 comparisons for pairs, n for in_box.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/space/grid/detail/bit_rows.hpp"
#include "plumb/space/grid/detail/box_slots.hpp"
#include "plumb/space/pairs/box_pair.hpp"

namespace plumb {

struct RowColumnGridOptions {
  std::size_t rows = 256;  // along each axis of a level; what is as many cells apart shares one
  int least_level = -1000;
  std::size_t most_memory = std::size_t{1} << 30;
};

template <class Box>
class RowColumnGrid {
 public:
  explicit RowColumnGrid(const RowColumnGridOptions& options = {});

  std::uint32_t insert(const Box& box);
  void remove(std::uint32_t handle);
  void move(std::uint32_t handle, const Box& box);

  [[nodiscard]] std::vector<BoxPair> overlapping_pairs(const BoxPairOptions& options = {},
                                                       std::vector<BoxPair> rows = {}) const;
  /// Ascending.
  [[nodiscard]] std::vector<std::uint32_t> in_box(const Box& box, const InBoxOptions& options = {},
                                                  std::vector<std::uint32_t> rows = {}) const;

  [[nodiscard]] std::size_t size() const { return boxes_.size(); }
  [[nodiscard]] bool contains(std::uint32_t handle) const { return boxes_.contains(handle); }
  [[nodiscard]] const Box& box(std::uint32_t handle) const { return boxes_[handle]; }
  /// That have a box.
  [[nodiscard]] std::size_t levels() const;
  [[nodiscard]] std::size_t memory() const;

 private:
  static constexpr std::size_t n = space::axes_of<Box>;
  struct Level {
    int level;
    space::BitRows<n> rows;
    std::vector<std::uint32_t> handles;  // of the slots
    std::vector<std::uint32_t> free;     // slots
  };
  struct Place {
    int level;
    std::uint32_t slot;
  };
  struct Scratch {
    std::vector<std::uint64_t> both, one;
  };

  Level& level_with_room(const char* function, int level);
  void put(std::uint32_t handle, Level& level, const space::CellSpan<n>& span);
  void take(std::uint32_t handle);
  template <class Visit>
  void for_overlapping(const Box& box, bool touching, Scratch& scratch, const Visit& visit) const;

  RowColumnGridOptions options_;
  space::BoxSlots<Box> boxes_;
  std::vector<Place> places_;  // of each handle
  std::vector<Level> levels_;  // ascending
};

using RowColumnGrid2 = RowColumnGrid<Aabb2>;
using RowColumnGrid3 = RowColumnGrid<Aabb3>;

}  // namespace plumb
