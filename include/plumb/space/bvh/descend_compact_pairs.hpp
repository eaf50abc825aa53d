// How are two trees asked together of which one is compact, or a compact one with itself?
//
//   descend_pairs(small_a.tree, small_b.tree, descend_larger{}, meets, visit);      // as binary ones (descend_pairs.hpp)
//   descend_own_pairs(small.tree, meets, visit);
//
// A BoxNode has the child's box and its link, as in descend_compact.hpp; of the root it has the tree's box.
// Laws: those of descend_pairs.hpp.
// Source: RTCD 6.3.3, 13.4.2.
// Cost: a node is opened for each pair in which it is replaced; one call of meets for each of its children.  Bounded
// by n^2 calls for n nodes of both.
#pragma once

#include "plumb/space/bvh/descend_compact.hpp"
#include "plumb/space/bvh/descend_pairs.hpp"

namespace plumb::space {

/// A place is the child itself, as its node says.
struct CompactPlaces {
  std::span<const CompactNode> nodes;
  FloatBox3 root;

  explicit CompactPlaces(const CompactTree& tree) : nodes(tree.nodes.view()), root(tree.box()) {}
  [[nodiscard]] bool empty() const { return nodes.empty(); }
  [[nodiscard]] const BoxNode& operator[](const BoxNode& place) const { return place; }
};

template <>
inline constexpr std::size_t most_children<CompactPlaces> = CompactNode::width;
template <>
inline constexpr std::size_t most_levels<CompactPlaces> = CompactTree::most_levels;

inline BoxNode root_place(const CompactPlaces& places) { return {places.root.min, 0, places.root.max, 0}; }

template <class Take>
void for_children(const CompactPlaces& places, const BoxNode& place, const Take& take) {
  const WideNode<8> node = places.nodes[place.link].widened();
  for (std::size_t i = CompactNode::width; i-- > 0;) {
    if (node.has(i)) take(child_of(node, i));
  }
}

/// Leaves have slots of their own, and a node's number is that of no slot: their counts differ.
inline bool is_same_place(const CompactPlaces&, const BoxNode& a, const BoxNode& b) {
  return a.link == b.link && a.count == b.count;
}
inline bool is_same_node(const CompactPlaces& places, const BoxNode& a, const BoxNode& b) {
  return is_same_place(places, a, b);
}

template <>
struct TreePlaces<CompactTree> {
  static CompactPlaces of(const CompactTree& tree) { return CompactPlaces(tree); }
};

}  // namespace plumb::space
