// What does it cost to ask a tree?  The surface-area heuristic's estimate, and the shape of the tree.
//
//   TreeCost cost = cost_of(tree);
//   double t = cost.total(1, 0.5);   // RTCD's T = Nv Cv + Np Cp, for a line that meets the root's box
//
// Laws: a line of uniform direction and place meets a convex body inside of another with the ratio of their areas as
//       probability; so nodes and items are what such a line meets on the average, if it is stopped by nothing.
// The numbers are estimates in doubles, and decide nothing.
// Source: RTCD 6.1.2; Goldsmith and Salmon 1987.
// Cost: linear in the nodes.  Nothing is searched.
#pragma once

#include <cstddef>
#include <cstdint>

#include "plumb/space/bvh/box_tree.hpp"

namespace plumb {

struct TreeCost {
  double nodes_met = 0;  // nodes whose boxes the line meets; Nv tests twice as many of their children
  double items_met = 0;  // items in the leaves that it meets: Np
  std::uint32_t nodes = 0, leaves = 0;
  std::uint32_t depth = 0;         // of the deepest leaf; the root's is 0
  std::uint32_t most_in_leaf = 0;  // items
  double mean_depth = 0;           // of an item

  /// A test of a node's box costs node_cost, that of an item item_cost.
  [[nodiscard]] double total(double node_cost, double item_cost) const {
    return nodes_met * node_cost + items_met * item_cost;
  }
};

/// All zero for no nodes.  Areas that are all zero (one point) count as met.
TreeCost cost_of(const BoxTree& tree);

}  // namespace plumb
