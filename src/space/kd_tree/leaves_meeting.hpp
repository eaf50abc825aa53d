// Which leaves of a k-d tree have a point of a box?
//
// Law: those whose half-open cells have a point of the closed box, each once.
// Cost: the nodes above them.
#pragma once

#include <array>

#include "plumb/space/kd_tree/split_tree.hpp"

namespace plumb::space::kd {

/// Calls visit(leaf).
template <class Figure, class Visit>
void for_leaves_meeting(const SplitTree<Figure>& tree, const typename SplitTree<Figure>::Box& box, const Visit& visit) {
  const auto low = coordinates(box.min), high = coordinates(box.max);
  if (tree.nodes.empty()) return;
  std::array<std::uint32_t, 64> stack;  // one a level
  std::size_t height = 0;
  stack[height++] = 0;
  while (height != 0) {
    const std::uint32_t at = stack[--height];
    const SplitNode& n = tree.nodes[at];
    if (n.is_leaf()) {
      visit(n.link);
      continue;
    }
    if (high[n.axis] >= n.plane) stack[height++] = n.link;
    if (low[n.axis] < n.plane) stack[height++] = at + 1;
  }
}

}  // namespace plumb::space::kd
