// Hybrid schemes: a uniform grid whose crowded cells have an octree each, or a k-d tree whose crowded leaves have a
// uniform grid each.  Which of many boxes are in a region, and which two overlap?
//
//   const GridOfTrees<Aabb3> world = build_grid_of_trees(boxes);
//   const TreeOfGrids<Aabb3> detail = build_tree_of_grids(boxes);
//   in_box(world, {{0, 0, 0}, {1, 1, 1}});  overlapping_pairs(detail, {.touching = false});
//
// A grid finds a place without a search, and is slow where boxes crowd in a cell; a tree goes down to them level by
// level.  In the first scheme a grid of large cells stands for the upper levels of trees, in the second grids stand for
// the lower levels of one.
// Laws: (1) in_box tells the boxes that meet the closed one, or without touching overlap it, ascending, and
// overlapping_pairs the pairs of box_pair.hpp, each once, a < b: both schemes the same, whatever the options.  (2) A
// box is in each cell that it reaches into, and so are two boxes in the cell that holds the lowest corner of what they
// have in common: that one cell tells of them.  (3) Cells, trees and the order of pairs depend on the boxes and the
// options alone, not on the number of threads.
// A number that is NaN or infinite throws NonFinite, an empty box, options out of range and more boxes than are
// numbered InvalidShape, and a grid that would take more than options.grid.most_memory Error.  To ask with an empty box
// tells nothing.
// Source: RTCD 7.3.8; the lowest corner as in Dittrich and Seeger 2000.
// Cost: that of its parts (docs/nearest.md); a box that reaches into many cells is kept in each.  Bounded by n^2
// comparisons for pairs, n for in_box.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/space/grid/static_grid.hpp"
#include "plumb/space/kd_tree/split_tree.hpp"
#include "plumb/space/octree/box_octree.hpp"

namespace plumb {

/// Which parts, cells or leaves, have an index of their own?  The boxes of others are asked one by one.
template <class Index>
struct CrowdedParts {
  static constexpr std::uint32_t none = 0xffffffff;

  std::vector<std::uint32_t> index_of;  // of each part, or none
  std::vector<Index> indexes;           // of a part's boxes, which are numbered by their places in it
};

/// Of Aabb2 or Aabb3.  Its parts are the grid's cells.
template <class Box>
struct GridOfTrees {
  using Figure = Box;

  StaticGrid<Box> grid;
  CrowdedParts<BoxCells<space::axes_of<Box>>> crowded;

  [[nodiscard]] std::size_t parts() const { return grid.cells(); }
  [[nodiscard]] std::span<const std::uint32_t> items_in(std::size_t cell) const { return grid.items_in(cell); }
  [[nodiscard]] const std::vector<Box>& boxes() const { return grid.boxes(); }
};

/// Of Aabb2 or Aabb3.  Its parts are the tree's leaves.
template <class Box>
struct TreeOfGrids {
  using Figure = Box;

  SplitTree<Box> tree;
  std::vector<Box> cells;                 // of its leaves, half-open, infinite at the border
  CrowdedParts<StaticGrid<Box>> crowded;  // what of the boxes is in the closed cell

  [[nodiscard]] std::size_t parts() const { return tree.leaves(); }
  [[nodiscard]] std::span<const std::uint32_t> items_in(std::size_t leaf) const { return tree.items_in(leaf); }
  [[nodiscard]] const std::vector<Box>& boxes() const { return tree.figures; }
};

struct HybridOptions {
  std::uint32_t in_part = 1024;     // at least 1: boxes of a cell on average, or more; of a leaf, or fewer
  std::uint32_t most_in_list = 32;  // a part of more boxes has a tree or a grid of its own
  GridOptions grid = {};            // the grid; each grid of a leaf
  Execution execution = Execution::parallel;
};

template <class Box>
GridOfTrees<Box> build_grid_of_trees(std::span<const Box> boxes, const HybridOptions& options = {});
template <class Box>
GridOfTrees<Box> build_grid_of_trees(const std::vector<Box>& boxes, const HybridOptions& options = {}) {
  return build_grid_of_trees(std::span<const Box>(boxes), options);
}
template <class Box>
TreeOfGrids<Box> build_tree_of_grids(std::span<const Box> boxes, const HybridOptions& options = {});
template <class Box>
TreeOfGrids<Box> build_tree_of_grids(const std::vector<Box>& boxes, const HybridOptions& options = {}) {
  return build_tree_of_grids(std::span<const Box>(boxes), options);
}

template <class Index>
concept HybridIndex = requires(const Index& index, std::size_t part) {
  index.crowded.index_of;
  index.items_in(part);
};

template <HybridIndex Index>
std::vector<std::uint32_t> in_box(const Index& index, const typename Index::Figure& box,
                                  const InBoxOptions& options = {}, std::vector<std::uint32_t> rows = {});
template <HybridIndex Index>
std::vector<BoxPair> overlapping_pairs(const Index& index, const BoxPairOptions& options = {},
                                       std::vector<BoxPair> rows = {});
/// Bytes that its arrays take.
template <HybridIndex Index>
std::size_t memory_of(const Index& index);

}  // namespace plumb
