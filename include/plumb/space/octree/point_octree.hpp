// Octree, quadtree of points: in which leaf is a place, which points are in a box?
//
//   const PointOctree tree = build_octree(points);            // build_quadtree in the plane
//   const std::uint32_t leaf = locate(tree.cells, place);
//   in_box(tree, Aabb3{{0, 0, 0}, {1, 1, 1}})                 // their numbers, ascending
//
// Laws: (1) a cell is cut where it holds more than most_in_leaf points and is not of the deepest level: equal points,
// and those that share a cell of that level, stay together in a leaf of any size.  (2) Each point is in the one leaf
// that locate names, points of a leaf ascend by code, then by number.  (3) in_box tells exactly those that lie in
// the closed box, or without touching those that overlap it, by comparisons; in an empty box lies none.  (4) The tree
// depends on the points and on most_in_leaf and most_depth alone: not on execution or the number of threads.
// No recursion.  NaN and infinity throw NonFinite ("build_octree: points[17].y is nan, ..."), options out of range and
// more than 2^32 - 2 points InvalidShape.
// Source: RTCD 7.3.1, 7.3.4, 7.3.5; Karras 2012 for building in parallel from sorted codes.
// Cost: linear: a code each, its sorting by digits, and a binary search for each cell.  Bounded by n operations a
// level, of which there are 31 at most.
#pragma once

#include "plumb/space/octree/cell_tree.hpp"
#include "plumb/space/pairs/box_pair.hpp"

namespace plumb {

struct OctreeOptions {
  std::uint32_t most_in_leaf = 8;  // at least 1
  std::uint32_t most_depth = 31;   // the root has depth 0; a frame's levels where that is less
  Execution execution = Execution::parallel;
};

template <std::size_t D>
struct PointCells {
  CellTree<D> cells;
  std::vector<typename CellKinds<D>::Point> points;  // in the order of cells.items
};
using PointOctree = PointCells<3>;
using PointQuadtree = PointCells<2>;

PointOctree build_octree(std::span<const Point3> points, const OctreeOptions& options = {});
PointQuadtree build_quadtree(std::span<const Point2> points, const OctreeOptions& options = {});

std::vector<std::uint32_t> in_box(const PointOctree& tree, const Aabb3& box, const InBoxOptions& options = {},
                                  std::vector<std::uint32_t> rows = {});
std::vector<std::uint32_t> in_box(const PointQuadtree& tree, const Aabb2& box, const InBoxOptions& options = {},
                                  std::vector<std::uint32_t> rows = {});

}  // namespace plumb
