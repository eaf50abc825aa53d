// Broad phase (implicit grid): which boxes overlap?  Bits of each row, column and layer, intersected by whole words.
//
//   ImplicitGrid3 grid(2.0);                             // cells of size 2
//   const std::uint32_t handle = grid.insert(box);
//   grid.move(handle, other);   grid.remove(handle);
//   grid.overlapping_pairs();   grid.in_box(box);
//
// Laws: those of list_grid.hpp; pairs ascend by a, then b.
// Errors are those of list_grid.hpp; a number of rows that is no power of two throws InvalidShape.
// Source: RTCD 7.1.5.
// Cost: insert and remove in proportion to the rows that a box reaches into, not to its cells; a query in proportion to
// all boxes, a 64th of an operation for each and row.  So it is for some thousands of boxes that are asked often, and
// for large ones among small.  Bounded by n^2 comparisons for pairs, n for in_box.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/space/grid/cell_size.hpp"
#include "plumb/space/grid/detail/bit_rows.hpp"
#include "plumb/space/grid/detail/box_slots.hpp"
#include "plumb/space/pairs/box_pair.hpp"

namespace plumb {

struct ImplicitGridOptions {
  std::size_t rows = 256;  // along each axis; what is as many cells apart shares one
  std::size_t most_memory = std::size_t{1} << 30;
};

template <class Box>
class ImplicitGrid {
 public:
  explicit ImplicitGrid(double cell_size, const ImplicitGridOptions& options = {});

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
  [[nodiscard]] double cell_size() const { return size_; }
  [[nodiscard]] std::size_t memory() const { return boxes_.memory() + rows_.memory(); }

 private:
  static constexpr std::size_t n = space::axes_of<Box>;

  ImplicitGridOptions options_;
  double size_, per_size_;
  space::BoxSlots<Box> boxes_;
  space::BitRows<n> rows_;
};

using ImplicitGrid2 = ImplicitGrid<Aabb2>;
using ImplicitGrid3 = ImplicitGrid<Aabb3>;

}  // namespace plumb
