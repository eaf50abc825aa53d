#include "plumb/space/bsp/bsp_order.hpp"

#include "certify/finite.hpp"
#include "space/bsp/plane_side.hpp"

namespace plumb {
namespace {

/// A child, or the pieces of a node whose nearer side is done.
struct OrderStep {
  BspChild child;
  bool is_own;
};

}  // namespace

std::vector<std::uint32_t> front_to_back(const BspTree& tree, const Point3& eye, std::vector<std::uint32_t> rows) {
  require_finite("front_to_back", eye);
  rows.clear();
  const auto tell = [&](std::uint32_t owner) {
    for (std::uint32_t i = tree.first_piece[owner]; i < tree.first_piece[owner + 1]; ++i) rows.push_back(i);
  };
  const bool stores_leaves = tree.kind == BspKind::leaf_storing;
  std::vector<OrderStep> todo{{tree.root, false}};
  while (!todo.empty()) {
    const auto [child, is_own] = todo.back();
    todo.pop_back();
    if (child.is_leaf() || is_own) {
      if (child.is_leaf() == stores_leaves) tell(child.index());
      continue;
    }
    const BspNode& node = tree.nodes[child.index()];
    const bool is_before = space::node_side(tree, node, eye) != Sign::negative;
    todo.push_back({is_before ? node.back : node.front, false});
    todo.push_back({child, true});
    todo.push_back({is_before ? node.front : node.back, false});
  }
  return rows;
}

}  // namespace plumb
