// How is a compact tree asked?  As a binary one is (descend.hpp), by the same functions, eight children a node.
//
//   descend(small.tree, [&](const BoxNode& n) { return meets(n); },         // may something below matter?
//           [&](std::uint32_t first, std::uint32_t count) { ... });         // the slots of a leaf
//   descend_nearer_first(small.tree, limit, bound, visit);
//
// The BoxNode has the child's box, as CompactNode::box gives it, and its slots; of a child that is no leaf `count` is 0,
// and `link` its node.  The root itself is not asked about.
// Laws: (1) descend visits each leaf at most once, children before their parent's later children, and exactly those all
//       of whose ancestors and selves enter.  (2) descend_nearer_first visits every leaf whose bound, like those of its
//       ancestors, is at most the final limit; of a node's children the nearer ones first.
// No recursion; a stack of fixed size.
// Source: RTCD 6.3.1, 6.3.2, 6.6.6.
// Cost: one call of enters or bound for each child of a node that is entered, whose box is made for it.  Bounded by n
// log n operations for n nodes, the order of each one's children.
#pragma once

#include <array>

#include "plumb/space/bvh/compact_tree.hpp"
#include "plumb/space/bvh/descend.hpp"

namespace plumb {

namespace space {

inline BoxNode child_of(const WideNode<8>& node, std::size_t i) {
  const auto& p = node.planes;
  return {{p[0][i], p[1][i], p[2][i]}, node.link[i], {p[3][i], p[4][i], p[5][i]}, node.count[i]};
}

}  // namespace space

template <class Enters, class Visit>
Descent descend(const CompactTree& tree, Enters&& enters, Visit&& visit) {
  const std::span<const CompactNode> nodes = tree.nodes.view();
  if (nodes.empty()) return Descent::go_on;
  struct Later {
    std::uint32_t link, count;
  };
  std::array<Later, CompactTree::most_waiting> later;
  later[0] = {0, 0};
  for (std::size_t waiting = 1; waiting > 0;) {
    const Later now = later[--waiting];
    if (now.count != 0) {
      if (space::visited(visit, now.link, now.count) == Descent::stop) return Descent::stop;
      continue;
    }
    const WideNode<8> node = nodes[now.link].widened();
    for (std::size_t i = CompactNode::width; i-- > 0;) {
      if (!node.has(i)) continue;
      const BoxNode child = space::child_of(node, i);
      if (enters(child)) later[waiting++] = {child.link, child.count};
    }
  }
  return Descent::go_on;
}

template <class Key, class Bound, class Visit>
Descent descend_nearer_first(const CompactTree& tree, Key& limit, Bound&& bound, Visit&& visit) {
  const std::span<const CompactNode> nodes = tree.nodes.view();
  if (nodes.empty()) return Descent::go_on;
  struct Later {
    Key key;
    std::uint32_t link, count;
  };
  std::array<Later, CompactTree::most_waiting> later;
  std::size_t waiting = 0;
  for (Later now{Key{}, 0, 0};;) {
    if (now.count != 0) {
      if (space::visited(visit, now.link, now.count, limit) == Descent::stop) return Descent::stop;
    } else {
      const WideNode<8> node = nodes[now.link].widened();
      const std::size_t own = waiting;
      for (std::size_t i = 0; i < CompactNode::width; ++i) {
        if (!node.has(i)) continue;
        const BoxNode child = space::child_of(node, i);
        const Key key = bound(child);
        if (key > limit) continue;
        std::size_t place = waiting++;  // the nearest last
        for (; place > own && later[place - 1].key < key; --place) later[place] = later[place - 1];
        later[place] = {key, child.link, child.count};
      }
    }
    do {
      if (waiting == 0) return Descent::go_on;
      --waiting;
    } while (later[waiting].key > limit);
    now = later[waiting];
  }
}

}  // namespace plumb
