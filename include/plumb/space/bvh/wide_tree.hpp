// How do boxes lie that are asked many at once?  A tree whose nodes hold up to four or eight boxes, in lanes.
//
//   const WideTree<8> wide = widen<8>(bvh.tree);
//
// A node holds the boxes of its children: the least x of all, the least y, ...  Child i is the node link[i] where
// count[i] is 0, else the slots link[i], ..., link[i] + count[i] - 1 of the binary tree, whose order of items is kept.
// Children come first; the others are missing, with both numbers 0 (node 0 is the root, which is nobody's child).
// Laws: (1) the slots of all leaves are those of the binary tree, each once, in its order within a node.  (2) A child's
//       box is that of the node of the binary tree that has the same slots.  (3) No node is deeper than
//       most_tree_depth.  (4) No items, no nodes; one leaf alone has a root above it.
// Source: RTCD 6.6, 13.7; Ylitie, Karras and Laine 2017 for the collapse.
// Cost: 32 bytes a child and those that are missing; made in linear time.  Nothing is searched: each node is passed
// once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "plumb/certify/batch.hpp"
#include "plumb/space/bvh/box_tree.hpp"
#include "plumb/space/bvh/kept_array.hpp"

namespace plumb {

template <std::size_t width>
struct alignas(64) WideNode {
  std::array<std::array<float, width>, 6> planes;  // min.x, min.y, min.z, max.x, max.y, max.z
  std::array<std::uint32_t, width> link, count;

  [[nodiscard]] bool has(std::size_t child) const { return (link[child] | count[child]) != 0; }
};

template <std::size_t width>
struct WideTree {
  KeptArray<WideNode<width>> nodes;
};

/// Of two children with the most area first, until there are `width`; below so few slots as make one leaf none are
/// looked for.  Defined for 4 and 8.
template <std::size_t width>
WideTree<width> widen(const BoxTree& tree, std::uint32_t most_in_leaf = 8, Execution execution = Execution::parallel);

extern template WideTree<4> widen<4>(const BoxTree&, std::uint32_t, Execution);
extern template WideTree<8> widen<8>(const BoxTree&, std::uint32_t, Execution);

}  // namespace plumb
