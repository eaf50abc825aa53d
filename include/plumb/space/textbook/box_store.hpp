// Broad phase (hgrid, implicit grid, loose octree): which boxes overlap, where they come, go and move?
// The structures of the textbook, which win no row of the measurements, by one interface.
//
//   HashedGrid3 grid({.cell_size = 2});                    // a list for each cell, in a table: cells without end
//   LinkedGrid3 within({.world = box, .cell_size = 2});    // in an array; what is beyond the world is in the last
//   ImplicitGrid3 bits({.cell_size = 2});                  // a bit for each box in its rows, columns and layers
//   HierarchicalGrid3 sizes;   RowColumnGrid3 both;        // a level for each size: lists of cells, or bits of rows
//   LooseOctree tree({.world = box});                      // cells that reach over their borders, in a tree
//   SweepLists lists;                                      // starts and ends in lists along each axis, with the pairs
//   const BoxHandle handle = grid.insert(box);
//   grid.move(handle, other);   grid.remove(handle);
//   grid.overlapping_pairs();                              // all at a time
//   grid.in_box(box);                                      // one at a time
//   grid.in_box(box, seen);                                // seen: VisitStamps or VisitBits
//
// Lists and bits of one size of cells have a box in each cell that it reaches into.  Levels have it where it reaches
// into no more than two cells along each axis: cells of level e are of size 2^e, in the list of the cell that holds its
// min, or in the bits of its rows.  So has a loose octree: a loose cell begins where the cell does and has twice its
// side, and no box is kept in a large cell because it lies across a border.
// Laws: (1) pairs are those of box_pair.hpp, of the handles; they ascend by a, then b; by cells of lists their order
// depends on what has been inserted, moved and removed.  (2) in_box tells the handles of the boxes that intersect the
// closed box, or without touching overlap it, ascending.  (3) Any options give the same answers. (4) A handle names one
// box for ever; what throws leaves all as it was.
// What overlaps a box comes up in each cell of a list grid that both reach into.  It is told once: by the lowest of
// these cells, which needs no memory, or by stamps or bits that remember it.  The lowest cell is as fast, and any
// number of threads may ask (docs/measurements.md).
// A cell size that is not above zero, rows that are no power of two, a level above 1023, an empty world, an empty box
// that is put in and a handle that holds no box throw InvalidShape, an empty box that is asked holds nothing; NaN and
// infinity throw NonFinite, what would take more than options.most_memory throws Error.
// Source: RTCD 7.1.2, 7.1.3, 7.1.5, 7.1.6, 7.2.1, 7.2.2, 7.3.6, 7.5.1, 7.7.1, 7.7.2, 7.7.3; Ulrich, "Loose octrees",
// Game Programming Gems, 2000; Baraff 1992.
// Cost: to insert, move and remove takes constant time, of lists in proportion to the cells of the box and to the boxes
// in them, of one size of bits to its rows; a move within the same cells is a copy.  in_box: by lists the cells of the
// box, by levels 27 cells for each, by bits a 64th of an operation for each box and row.  All pairs: of levels and
// octrees a sort by x, and for each level that has a box one of all that are no higher.  Starts and ends take a step
// for each that a box passes along each axis: n for a new one; in_box asks each box.  Bounded by n^2 comparisons for
// pairs (of lists for each cell, of which most_memory says how many), n for in_box and each level.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "plumb/figure/basic/box.hpp"
#include "plumb/space/coherence/visit_bits.hpp"
#include "plumb/space/coherence/visit_stamps.hpp"
#include "plumb/space/pairs/box_pair.hpp"
#include "plumb/space/sort_and_sweep/sort_and_sweep.hpp"

namespace plumb {

enum class BoxScheme : unsigned char {
  linked_grid,
  hashed_grid,
  implicit_grid,
  hierarchical_grid,
  row_column_grid,
  loose_octree,
  sweep_lists
};

/// Each scheme looks at what it has.
template <class Box>
struct BoxStoreOptions {
  Box world = {};           // of linked grids and loose octrees; what lies outside is found as well
  double cell_size = 1;     // of linked, hashed and implicit grids
  std::size_t rows = 256;   // of bits along each axis, or each of a level; what is as many cells apart shares one
  int least_level = -1000;  // boxes that would be lower are here: fewer levels
  std::size_t most_memory = std::size_t{1} << 30;  // bytes of linked, hashed, implicit and row-column grids
  int lists = 3;                        // along 1, 2 or 3 axes, of which the plane has two; x comes after the last
  SweepAxis first_axis = SweepAxis::x;  // not greatest_variance, which is known of boxes that are there
};

template <class Box, BoxScheme scheme>
class BoxStore {
 public:
  explicit BoxStore(const BoxStoreOptions<Box>& options = {});
  BoxStore(BoxStore&&) noexcept;
  BoxStore& operator=(BoxStore&&) noexcept;
  ~BoxStore();

  BoxHandle insert(const Box& box);
  void remove(const BoxHandle& handle);
  void move(const BoxHandle& handle, const Box& box);

  [[nodiscard]] std::vector<HandlePair> overlapping_pairs(const BoxPairOptions& options = {},
                                                          std::vector<HandlePair> rows = {}) const;
  /// Ascending.  Stamps and bits are made to fit.
  [[nodiscard]] std::vector<BoxHandle> in_box(const Box& box, const InBoxOptions& options = {},
                                              std::vector<BoxHandle> rows = {}) const;
  [[nodiscard]] std::vector<BoxHandle> in_box(const Box& box, VisitStamps& seen, const InBoxOptions& options = {},
                                              std::vector<BoxHandle> rows = {}) const;
  [[nodiscard]] std::vector<BoxHandle> in_box(const Box& box, VisitBits& seen, const InBoxOptions& options = {},
                                              std::vector<BoxHandle> rows = {}) const;

  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] bool contains(const BoxHandle& handle) const;
  [[nodiscard]] const Box& box(const BoxHandle& handle) const;
  /// Levels that have a box, cells of an octree; 1 where there is one size of cells.
  [[nodiscard]] std::size_t parts() const;
  [[nodiscard]] std::size_t memory() const;

 private:
  struct State;
  template <class Seen>
  [[nodiscard]] std::vector<BoxHandle> found(const Box& box, const InBoxOptions& options, Seen& seen,
                                             std::vector<BoxHandle> rows) const;

  std::unique_ptr<State> state_;
};

template <class Box>
using LinkedGrid = BoxStore<Box, BoxScheme::linked_grid>;
template <class Box>
using HashedGrid = BoxStore<Box, BoxScheme::hashed_grid>;
template <class Box>
using ImplicitGrid = BoxStore<Box, BoxScheme::implicit_grid>;
template <class Box>
using HierarchicalGrid = BoxStore<Box, BoxScheme::hierarchical_grid>;
template <class Box>
using RowColumnGrid = BoxStore<Box, BoxScheme::row_column_grid>;
template <class Box>
using LooseCells = BoxStore<Box, BoxScheme::loose_octree>;

using LinkedGrid2 = LinkedGrid<Aabb2>;
using LinkedGrid3 = LinkedGrid<Aabb3>;
using HashedGrid2 = HashedGrid<Aabb2>;
using HashedGrid3 = HashedGrid<Aabb3>;
using ImplicitGrid2 = ImplicitGrid<Aabb2>;
using ImplicitGrid3 = ImplicitGrid<Aabb3>;
using HierarchicalGrid2 = HierarchicalGrid<Aabb2>;
using HierarchicalGrid3 = HierarchicalGrid<Aabb3>;
using RowColumnGrid2 = RowColumnGrid<Aabb2>;
using RowColumnGrid3 = RowColumnGrid<Aabb3>;
using LooseQuadtree = LooseCells<Aabb2>;
using LooseOctree = LooseCells<Aabb3>;
using SweepLists2 = BoxStore<Aabb2, BoxScheme::sweep_lists>;
using SweepLists = BoxStore<Aabb3, BoxScheme::sweep_lists>;

}  // namespace plumb
