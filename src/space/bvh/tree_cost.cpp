#include "plumb/space/bvh/tree_cost.hpp"

#include <algorithm>
#include <vector>

namespace plumb {
namespace {

double node_area(const BoxNode& n) {
  const double x = static_cast<double>(n.max[0]) - n.min[0], y = static_cast<double>(n.max[1]) - n.min[1],
               z = static_cast<double>(n.max[2]) - n.min[2];
  return x * y + y * z + z * x;
}

}  // namespace

TreeCost cost_of(const BoxTree& tree) {
  TreeCost cost;
  const std::span<const BoxNode> nodes = tree.nodes.view();
  if (nodes.empty()) return cost;
  const double all = node_area(nodes[0]);
  cost.nodes = static_cast<std::uint32_t>(nodes.size());
  std::vector<std::uint32_t> depth(nodes.size());  // of parents before their children
  double depths = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const BoxNode& node = nodes[i];
    const double met = all > 0 ? node_area(node) / all : 1;
    cost.nodes_met += met;
    if (!node.is_leaf()) {
      depth[i + 1] = depth[i + node.link] = depth[i] + 1;
      continue;
    }
    cost.items_met += met * node.count;
    ++cost.leaves;
    cost.depth = std::max(cost.depth, depth[i]);
    cost.most_in_leaf = std::max(cost.most_in_leaf, node.count);
    depths += static_cast<double>(depth[i]) * node.count;
  }
  cost.mean_depth = depths / static_cast<double>(tree.items.size());
  return cost;
}

}  // namespace plumb
