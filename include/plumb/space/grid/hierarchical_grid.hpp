// Broad phase (hierarchical grid, hgrid): which boxes overlap, whatever their sizes?  Levels of grids of cells twice as
// large each.
//
//   HierarchicalGrid3 grid;
//   const std::uint32_t handle = grid.insert(box);       // at the level whose cells are about as large as it is
//   grid.move(handle, other);   grid.remove(handle);
//   grid.overlapping_pairs();   grid.in_box(box);
//
// Cells of level e are of size 2^e.  A box is at the lowest level at which it reaches into no more than two cells along
// each axis, in the list of the cell that holds its min.  So what overlaps it at its own and higher levels is in the
// lists of at most three cells along each axis.  All pairs are found level by level, by the rows of cells along x: each
// level's boxes with one another and with those of all lower levels.
// Laws: those of list_grid.hpp; pairs ascend by a, then b.  Levels without a box cost nothing.
// Errors are those of list_grid.hpp, but for memory: a box takes as much as any other.
// Source: RTCD 7.2.1.
// Cost: insert, move and remove take constant time (a table that grows moves what is in it); overlapping 27 lists for
// each level that is occupied; pairs a sort by x, and for each level that is occupied one of all that are no higher.
// Bounded by n^2 comparisons for pairs, n for in_box and each level.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/space/grid/detail/box_slots.hpp"
#include "plumb/space/grid/detail/cell_span.hpp"
#include "plumb/space/pairs/box_pair.hpp"

namespace plumb {

struct HierarchicalGridOptions {
  int least_level = -1000;  // boxes that would be lower are here: fewer levels
};

template <class Box>
class HierarchicalGrid {
 public:
  explicit HierarchicalGrid(const HierarchicalGridOptions& options = {});

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
  [[nodiscard]] std::size_t levels() const { return levels_.size(); }
  [[nodiscard]] std::size_t memory() const;

 private:
  static constexpr std::size_t n = space::axes_of<Box>;
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  using Span = space::CellSpan<n>;
  struct Entry {
    Span span;
    int level;
    std::uint32_t next, previous;  // in the list of a place
  };
  struct Level {
    int level;
    std::size_t boxes;
  };

  [[nodiscard]] std::size_t place_of(int level, const space::CellNumber<n>& cell) const;
  void link(std::uint32_t handle);
  void unlink(std::uint32_t handle);
  void grow();
  void count(int level, bool more);
  template <class Visit>
  void for_list(int level, const space::CellNumber<n>& cell, const Visit& visit) const;

  HierarchicalGridOptions options_;
  space::BoxSlots<Box> boxes_;
  std::vector<Entry> entries_;        // of each handle
  std::vector<std::uint32_t> heads_;  // the first of each list
  std::vector<Level> levels_;         // that have a box, ascending
};

using HierarchicalGrid2 = HierarchicalGrid<Aabb2>;
using HierarchicalGrid3 = HierarchicalGrid<Aabb3>;

}  // namespace plumb
