// The ways from items with boxes to a tree.  All keep the laws of plumb/space/bvh/box_tree.hpp and build.hpp.
#pragma once

#include <span>
#include <vector>

#include "plumb/space/bvh/build.hpp"
#include "space/bvh/boxed_item.hpp"

namespace plumb::space {

/// Nodes, and items[slot].
struct Built {
  std::vector<BoxNode> nodes;
  std::vector<std::uint32_t> items;
};

// Of at least one item, by the method that the options name.
Built build(std::vector<BoxedItem> items, const BvhOptions& options);

/// As a part of a tree, so deep in it.
Built build_binned(std::vector<BoxedItem> items, const BvhOptions& options, std::uint32_t depth = 0);
Built build_by_sweeps(const std::vector<BoxedItem>& items, const BvhOptions& options);
Built build_at_places(std::vector<BoxedItem> items, const BvhOptions& options);
Built build_linear(const std::vector<BoxedItem>& items, const BvhOptions& options);
Built build_agglomerative(const std::vector<BoxedItem>& items, const BvhOptions& options);
Built build_of_nearest_pairs(const std::vector<BoxedItem>& items, const BvhOptions& options);
Built build_by_insertion(const std::vector<BoxedItem>& items, const BvhOptions& options);

/// Indices of the items along a curve through space; equal codes by index.
std::vector<std::uint32_t> morton_order(Execution execution, std::span<const BoxedItem> items);

}  // namespace plumb::space
