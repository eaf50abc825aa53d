#include "tool/bvh/command.hpp"

namespace plumb::tool {
namespace {

double area_of(const BoxNode& n) {
  const double x = double(n.max[0]) - n.min[0], y = double(n.max[1]) - n.min[1], z = double(n.max[2]) - n.min[2];
  return x * y + y * z + z * x;
}

}  // namespace

std::vector<std::uint32_t> depths_of(const BoxTree& tree) {
  const std::span<const BoxNode> nodes = tree.nodes.view();
  std::vector<std::uint32_t> depth(nodes.size());  // of parents before their children
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].is_leaf()) depth[i + 1] = depth[i + nodes[i].link] = depth[i] + 1;
  }
  return depth;
}

std::vector<TreeLevel> levels_of(const BoxTree& tree) {
  const std::span<const BoxNode> nodes = tree.nodes.view();
  const std::vector<std::uint32_t> depth = depths_of(tree);
  std::vector<TreeLevel> levels;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (levels.size() <= depth[i]) levels.resize(depth[i] + std::size_t{1});
    TreeLevel& level = levels[depth[i]];
    const double all = area_of(nodes[0]), met = all > 0 ? area_of(nodes[i]) / all : 1;
    ++level.nodes;
    level.nodes_met += met;
    if (!nodes[i].is_leaf()) continue;
    ++level.leaves;
    level.items_met += met * nodes[i].count;
  }
  return levels;
}

}  // namespace plumb::tool
