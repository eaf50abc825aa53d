// Which cells does a tree of items with sorted keys have?  Level by level, each level's cells in parallel.
//
// Laws: (1) a cell is cut exactly where it has more than most_in_leaf items that are not its own and is not of the
// level most_depth; its own are those that no child holds.  (2) The items of a child are a run of its parent's; the
// parent's own lie between those of its lower and its upper half.
// Source: Karras, "Maximizing parallelism in the construction of BVHs, octrees, and k-d trees", 2012.
// Cost: 2^D binary searches a cell that is cut.
#pragma once

#include <span>
#include <vector>

#include "plumb/space/octree/point_octree.hpp"
#include "space/octree/keyed_items.hpp"

namespace plumb::space {

/// `are_points`: all items have keys of the deepest level, so that no other cell has own ones.
template <std::size_t D>
std::vector<CellNode> cut_cells(std::span<const KeyedItem> sorted, bool are_points, const OctreeOptions& options);

/// Throws InvalidShape, naming the function.
void check_octree_options(std::string_view function, const OctreeOptions& options, std::size_t items);

}  // namespace plumb::space
