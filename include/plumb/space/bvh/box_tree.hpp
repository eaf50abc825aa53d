// How does a tree of boxes lie in memory?  An array of nodes in depth-first order, and the items in the nodes' order.
//
//   node 0 is the root; a node that is no leaf has its first child right behind it, and the second `link` further.
//   A leaf holds the slots link, ..., link + count - 1, and items[slot] is the number of the item in that slot.
//
// Laws: (1) every item is in exactly one slot, and every slot in exactly one leaf; leaves have slots in the order of
//       the nodes.  (Spatial splits put an item into several.)  (2) Every node's box contains its items' boxes,
//       exactly: as numbers of the frame, compared with the doubles; of an item in several slots its leaves' boxes
//       contain together what it stands for, the triangle.  (3) It contains its children's boxes.  (4) No
//       leaf is deeper than most_tree_depth, so whoever descends needs that many places of a stack.  (5) No items, no
//       nodes.
// Source: RTCD 6.4.2, 6.6.2, 6.6.3.
// Cost: 32 bytes a node, 4 a slot.  Nothing is searched.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "plumb/space/bvh/box_frame.hpp"
#include "plumb/space/bvh/kept_array.hpp"

namespace plumb {

struct alignas(32) BoxNode {
  std::array<float, 3> min;
  std::uint32_t link;  // of a leaf: its first slot; else: how many nodes further the second child is
  std::array<float, 3> max;
  std::uint32_t count;  // of a leaf: its slots; else 0

  [[nodiscard]] bool is_leaf() const { return count != 0; }
  [[nodiscard]] FloatBox3 box() const { return {min, max}; }
  friend bool operator==(const BoxNode&, const BoxNode&) = default;
};

/// Edges between the root and a leaf.
inline constexpr std::uint32_t most_tree_depth = 64;

/// Around nothing: its least is infinite, and above its most.
inline constexpr FloatBox3 no_box = [] {
  constexpr float far = std::numeric_limits<float>::infinity();
  return FloatBox3{{far, far, far}, {-far, -far, -far}};
}();

struct BoxTree {
  KeptArray<BoxNode> nodes;
  KeptArray<std::uint32_t> items;
  BoxFrame frame;

  /// Around all items.
  [[nodiscard]] FloatBox3 box() const { return nodes.empty() ? no_box : nodes[0].box(); }
};

}  // namespace plumb
