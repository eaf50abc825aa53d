// Broad phase (uniform grids of linked lists): which boxes overlap, where they come, go and move?
//
//   HashedGrid3 grid(2.0);                               // cells of size 2, without end
//   LinkedGrid3 within(world, 2.0);                      // an array of cells; what is beyond the world is in the last
//   const std::uint32_t handle = grid.insert(box);
//   grid.move(handle, other);   grid.remove(handle);
//   grid.overlapping_pairs()                                         // all at a time
//   grid.in_box(box, seen)                               // one at a time; seen: VisitStamps, VisitBits, or nothing
//
// A box is in the list of each cell that it reaches into.  The lists of LinkedGrid are those of an array of cells, of
// HashedGrid those of a table, in which cells that share a place are told apart by their numbers.
// Laws: (1) pairs are those of box_pair.hpp, of the handles.  Their order depends on what has been inserted, moved and
// removed.  (2) Any size of cells gives the same pairs.  (3) A handle is given again after its box has been removed;
// what throws leaves the grid as it was.
// What overlaps a box comes up in each cell that both reach into.  It is told once: by the lowest of these cells, as of
// pairs, which needs no memory; or by stamps or bits that remember it, which spares the test of boxes.  The
// lowest cell is as fast, and any number of threads may ask (docs/measurements.md).
// A cell size that is not above zero, an empty box that is put in and a handle that is not in the grid throw
// InvalidShape, an empty box that is asked holds nothing; NaN and infinity throw NonFinite, a grid that would take more
// than options.most_memory throws Error.
// Source: RTCD 7.1.2, 7.1.3, 7.1.6, 7.7.1, 7.7.2, 7.7.3.
// Cost: insert, move and remove in proportion to the cells of the box, and to the boxes in them; a move within the same
// cells is a copy.  Bounded by n^2 comparisons for each cell, and by the cells, of which most_memory says how many.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "plumb/space/coherence/visit_bits.hpp"
#include "plumb/space/coherence/visit_stamps.hpp"
#include "plumb/space/grid/cell_size.hpp"
#include "plumb/space/grid/detail/box_slots.hpp"
#include "plumb/space/grid/detail/cell_span.hpp"
#include "plumb/space/pairs/box_pair.hpp"

namespace plumb {

enum class CellTable : unsigned char { array, hashed };

template <class Box, CellTable table>
class ListGrid {
 public:
  /// options.cell_size is not looked at.
  explicit ListGrid(double cell_size, const GridOptions& options = {}) requires(table == CellTable::hashed)
      : ListGrid(nullptr, cell_size, options) {}
  ListGrid(const Box& world, double cell_size, const GridOptions& options = {}) requires(table == CellTable::array)
      : ListGrid(&world, cell_size, options) {}

  std::uint32_t insert(const Box& box);
  void remove(std::uint32_t handle);
  void move(std::uint32_t handle, const Box& box);

  [[nodiscard]] std::vector<BoxPair> overlapping_pairs(const BoxPairOptions& options = {},
                                                       std::vector<BoxPair> rows = {}) const;
  /// Ascending.  Stamps and bits are made to fit.
  [[nodiscard]] std::vector<std::uint32_t> in_box(const Box& box, const InBoxOptions& options = {},
                                                  std::vector<std::uint32_t> rows = {}) const;
  [[nodiscard]] std::vector<std::uint32_t> in_box(const Box& box, VisitStamps& seen, const InBoxOptions& options = {},
                                                  std::vector<std::uint32_t> rows = {}) const;
  [[nodiscard]] std::vector<std::uint32_t> in_box(const Box& box, VisitBits& seen, const InBoxOptions& options = {},
                                                  std::vector<std::uint32_t> rows = {}) const;

  [[nodiscard]] std::size_t size() const { return boxes_.size(); }
  [[nodiscard]] bool contains(std::uint32_t handle) const { return boxes_.contains(handle); }
  [[nodiscard]] const Box& box(std::uint32_t handle) const { return boxes_[handle]; }
  [[nodiscard]] double cell_size() const { return size_; }
  [[nodiscard]] std::size_t memory() const;

 private:
  static constexpr std::size_t n = space::axes_of<Box>;
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  using Span = space::CellSpan<n>;
  struct Node {
    space::CellNumber<n> cell;
    std::uint32_t box, next;
  };

  ListGrid(const Box* world, double cell_size, const GridOptions& options);

  [[nodiscard]] Span span_of(const Box& box) const;
  [[nodiscard]] std::size_t place_of(const space::CellNumber<n>& cell) const;
  void require_room(std::string_view function, const Span& span) const;
  void grow(std::size_t nodes);
  void link(std::uint32_t handle);
  void unlink(std::uint32_t handle);
  template <class Seen>
  [[nodiscard]] std::vector<std::uint32_t> found(const Box& box, bool touching, Seen& seen,
                                                 std::vector<std::uint32_t> rows) const;

  GridOptions options_;
  double size_, per_size_;
  Span all_{};  // of an array of cells
  space::BoxSlots<Box> boxes_;
  std::vector<Span> spans_;           // of each handle
  std::vector<std::uint32_t> heads_;  // the first node of each list
  std::vector<Node> nodes_;
  std::uint32_t free_ = none;  // the first of the nodes that are not in use
  std::size_t used_ = 0;       // nodes
};

template <class Box>
using LinkedGrid = ListGrid<Box, CellTable::array>;
template <class Box>
using HashedGrid = ListGrid<Box, CellTable::hashed>;
using LinkedGrid2 = LinkedGrid<Aabb2>;
using LinkedGrid3 = LinkedGrid<Aabb3>;
using HashedGrid2 = HashedGrid<Aabb2>;
using HashedGrid3 = HashedGrid<Aabb3>;

}  // namespace plumb
