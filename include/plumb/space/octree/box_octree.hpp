// Octree, quadtree of boxes: which boxes are in a region, which two overlap?  Each box in the smallest cell that holds
// it, or in every leaf that it meets.
//
//   const BoxOctree tree = build_octree(boxes, {.rule = CellRule::every_leaf});
//   in_box(tree, Aabb3{{0, 0, 0}, {1, 1, 1}})               // their numbers, ascending
//   overlapping_pairs(tree)                                   // and, in the same order, those of any number of threads
//
// Laws: (1) by CellRule::smallest_cell a box is in one cell, the smallest of the tree that holds it: so two boxes that
// meet are in cells of which one is the other or holds it.  A cell is cut where more than most_in_leaf boxes have a
// smaller one.  (2) By CellRule::every_leaf it is in each leaf that has a point of it.  A leaf is cut where it has more
// than most_in_leaf boxes and its children would not have more than twice as many together; while the boxes' places in
// all leaves are at most most_references times as many as boxes, leaves of one level by their codes.  (3) Half-open
// cells: a box that ends at a border is in the cell that begins there, too.  (4) in_box tells exactly the boxes that
// intersect the closed box, or without touching those that overlap it, and overlapping_pairs the pairs of box_pair.hpp,
// by either rule the same pairs.  (5) Tree and order depend on the boxes and the options alone: not on execution or the
// number of threads.
// No recursion.  NaN and infinity throw NonFinite, empty boxes ("build_octree: boxes[17] is empty; leave it out") and
// options out of range InvalidShape; to ask with an empty box gives nothing.
// Source: RTCD 7.3.2, 7.3.5.
// Cost: as of points; every_leaf a step for each cell on the way to a box's leaves.  smallest_cell keeps each box once,
// but boxes across the middle stay in large cells: there they are swept along x, and so are those of smaller cells with
// what reaches into these.  Bounded by n^2 comparisons for pairs, n for in_box; the making by most_references.
#pragma once

#include "plumb/space/octree/point_octree.hpp"
#include "plumb/space/pairs/box_pair.hpp"

namespace plumb {

enum class CellRule : unsigned char { smallest_cell, every_leaf };

struct BoxOctreeOptions {
  std::uint32_t most_in_leaf = 8;  // at least 1
  std::uint32_t most_depth = 31;   // the root has depth 0; a frame's levels where that is less
  CellRule rule = CellRule::smallest_cell;
  double most_references = 8;  // from 1 to 1000
  Execution execution = Execution::parallel;
};

template <std::size_t D>
struct BoxCells {
  CellTree<D> cells;
  std::vector<typename CellKinds<D>::Box> boxes;  // in the order of cells.items
  CellRule rule = CellRule::smallest_cell;
};
using BoxOctree = BoxCells<3>;
using BoxQuadtree = BoxCells<2>;

/// Where in items a cell's own are, which none of its children holds: all of a leaf.
struct OwnItems {
  std::uint32_t begin, end;
};
template <std::size_t D>
OwnItems own_items(const CellTree<D>& tree, std::uint32_t node) {
  const CellNode& n = tree.nodes[node];
  if (n.is_leaf()) return {n.begin, n.end};
  const std::uint32_t middle = n.children + (std::uint32_t{1} << (D - 1));
  return {tree.nodes[middle - 1].end, tree.nodes[middle].begin};
}

BoxOctree build_octree(std::span<const Aabb3> boxes, const BoxOctreeOptions& options = {});
BoxQuadtree build_quadtree(std::span<const Aabb2> boxes, const BoxOctreeOptions& options = {});

std::vector<std::uint32_t> in_box(const BoxOctree& tree, const Aabb3& box, const InBoxOptions& options = {},
                                  std::vector<std::uint32_t> rows = {});
std::vector<std::uint32_t> in_box(const BoxQuadtree& tree, const Aabb2& box, const InBoxOptions& options = {},
                                  std::vector<std::uint32_t> rows = {});

std::vector<BoxPair> overlapping_pairs(const BoxOctree& tree, const BoxPairOptions& options = {},
                                       std::vector<BoxPair> rows = {});
std::vector<BoxPair> overlapping_pairs(const BoxQuadtree& tree, const BoxPairOptions& options = {},
                                       std::vector<BoxPair> rows = {});

}  // namespace plumb
