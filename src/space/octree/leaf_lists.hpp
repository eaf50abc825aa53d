// Which leaves does each box meet?  The tree of CellRule::every_leaf.
//
// Laws: those of box_octree.hpp.
// Cost: a step for each box and cell that it meets; twice the memory of the references of two levels.
#pragma once

#include <span>

#include "plumb/space/octree/box_octree.hpp"
#include "space/octree/seen_cells.hpp"

namespace plumb::space {

/// Nodes and items; the frame is left as it is.
template <std::size_t D>
void list_in_leaves(std::span<const PlaceRange<D>> boxes, const BoxOctreeOptions& options, CellTree<D>& tree);

}  // namespace plumb::space
