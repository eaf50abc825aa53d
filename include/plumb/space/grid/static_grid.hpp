// Broad phase (static uniform grid): which of many boxes that do not change overlap?  Cells are slices of one array.
//
//   const StaticGrid3 grid(boxes);                       // options.cell_size, or what choose_cell_size says
//   for (const BoxPair& p : grid.overlapping_pairs()) use(p.a, p.b);
//   grid.in_box(box)                                    // the numbers of those that overlap one, ascending
//
// A counting sort: how many boxes reach into each cell, where each slice begins, and then the numbers themselves.
// Laws: (1) pairs are those of box_pair.hpp, in the order of the cells that tell of them: of all cells that two boxes
// share the lowest.  (2) Any size of cells gives the same pairs; of a chosen size cells are made larger where there
// would be more than some for each box.
// A cell size that is not above zero and boxes that are empty throw InvalidShape; NaN and infinity NonFinite; a grid
// that would take more than options.most_memory throws Error.
// Source: RTCD 7.1.4, 7.1.6.
// Cost: time and memory in proportion to the cells that boxes reach into, and to the pairs of boxes in one cell; a
// slice of many boxes is swept along x.  Bounded by n^2 comparisons for each cell, and by the cells, of which
// most_memory says how many.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/space/grid/cell_size.hpp"
#include "plumb/space/grid/detail/cell_span.hpp"
#include "plumb/space/pairs/box_pair.hpp"

namespace plumb {

template <class Box>
class StaticGrid {
 public:
  explicit StaticGrid(std::span<const Box> boxes, const GridOptions& options = {});

  /// All at a time.
  [[nodiscard]] std::vector<BoxPair> overlapping_pairs(const BoxPairOptions& options = {},
                                                       std::vector<BoxPair> rows = {}) const;
  /// One at a time.
  [[nodiscard]] std::vector<std::uint32_t> in_box(const Box& box, const InBoxOptions& options = {},
                                                  std::vector<std::uint32_t> rows = {}) const;

  [[nodiscard]] double cell_size() const { return size_; }
  [[nodiscard]] std::size_t cells() const { return starts_.empty() ? 0 : starts_.size() - 1; }
  /// How many cells boxes reach into, counted for each.
  [[nodiscard]] std::size_t entries() const { return numbers_.size(); }
  [[nodiscard]] std::size_t memory() const;

  [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }
  /// Of cells, numbered with the first axis fastest: the boxes that reach into one, ascending; the cells that a box
  /// reaches into, ascending; the one that tells of two boxes that meet, of which one at least is in the grid.
  [[nodiscard]] std::span<const std::uint32_t> items_in(std::size_t cell) const {
    return std::span(numbers_).subspan(starts_[cell], starts_[cell + 1] - starts_[cell]);
  }
  [[nodiscard]] std::vector<std::size_t> cells_meeting(const Box& box) const;
  [[nodiscard]] std::size_t cell_of_pair(const Box& a, const Box& b) const;

 private:
  static constexpr std::size_t n = space::axes_of<Box>;
  using Span = space::CellSpan<n>;
  struct Member {  // of a cell
    Box box;
    space::CellNumber<n> first;
    std::uint32_t number;
  };

  void fill();
  [[nodiscard]] bool clip(Span& span) const;
  [[nodiscard]] std::size_t slice_of(const space::CellNumber<n>& cell) const;
  void pairs_in(std::size_t cell, bool touching, std::vector<Member>& members, std::vector<BoxPair>& out) const;

  std::vector<Box> boxes_;
  double size_ = 1, per_size_ = 1;
  Span all_{};                          // the cells of the grid
  std::vector<Span> spans_;             // of each box
  std::vector<std::uint32_t> starts_;   // of the slices of numbers_
  std::vector<std::uint32_t> numbers_;  // of the boxes in each cell, ascending
};

using StaticGrid2 = StaticGrid<Aabb2>;
using StaticGrid3 = StaticGrid<Aabb3>;

}  // namespace plumb
