// How is a tree asked?  Its nodes are looked at from the root on, and what is behind a node that cannot answer is not.
//
//   descend(tree, [&](const BoxNode& n) { return meets(n); },         // may something below matter?
//           [&](std::uint32_t first, std::uint32_t count) { ... });   // the slots of a leaf
//   descend_nearer_first(tree, limit, bound, visit);                  // depth first, of two children the nearer: rays
//   descend_nearest_first(tree, limit, bound, visit);                 // always the nearest node: distances
//
// A visit may return Descent::stop (or nothing, which goes on); then the descent returns it too.
// A tree is a BoxTree, or any that lies in memory as it does (volume_tree.hpp): `nodes`, each of which has is_leaf(), link
// and count.
// bound(node) is at most what any item below has; visit(first, count, limit) may lower the limit.  Nodes whose bound is
// above the limit are left out, those equal to it are not, so that ties reach the visit.
// Laws: (1) descend visits each leaf at most once, in the order of the slots, and exactly those all of whose ancestors
//       and selves enter.  (2) The others visit every leaf whose bound, like those of its ancestors, is at most the
//       final limit.  (3) Nearest first: bounds of visited leaves do not fall, where a child's bound is not below its
//       parent's.
// No recursion; the first two take a stack of fixed size, the last a heap.
// Source: RTCD 6.3.1, 6.3.2, 6.6.6.
// Cost: one call of enters or bound for each child of a node that is entered.  Bounded by n log n operations for n
// nodes, the order by distance.
#pragma once

#include <array>
#include <queue>
#include <type_traits>
#include <utility>
#include <vector>

#include "plumb/space/bvh/box_tree.hpp"

namespace plumb {

enum class Descent : bool { go_on, stop };

namespace space {

// What a visit says, where it says something.
template <class Visit, class... Arguments>
Descent visited(Visit& visit, Arguments&&... arguments) {
  if constexpr (std::is_void_v<std::invoke_result_t<Visit&, Arguments...>>) {
    visit(std::forward<Arguments>(arguments)...);
    return Descent::go_on;
  } else {
    return visit(std::forward<Arguments>(arguments)...);
  }
}

template <class Key>
struct Keyed {
  Key key;
  std::uint32_t node;
};

}  // namespace space

template <class Tree, class Enters, class Visit>
Descent descend(const Tree& tree, Enters&& enters, Visit&& visit) {
  const auto nodes = tree.nodes.view();
  if (nodes.empty() || !enters(nodes[0])) return Descent::go_on;
  std::array<std::uint32_t, most_tree_depth> later;
  std::size_t waiting = 0;
  for (std::uint32_t i = 0;;) {
    const auto& node = nodes[i];
    if (!node.is_leaf()) {
      const std::uint32_t second = i + node.link;
      const bool first_enters = enters(nodes[i + 1]), second_enters = enters(nodes[second]);
      if (first_enters) {
        if (second_enters) later[waiting++] = second;
        i = i + 1;
        continue;
      }
      if (second_enters) {
        i = second;
        continue;
      }
    } else if (space::visited(visit, node.link, node.count) == Descent::stop) {
      return Descent::stop;
    }
    if (waiting == 0) return Descent::go_on;
    i = later[--waiting];
  }
}

template <class Tree, class Key, class Bound, class Visit>
Descent descend_nearer_first(const Tree& tree, Key& limit, Bound&& bound, Visit&& visit) {
  const auto nodes = tree.nodes.view();
  if (nodes.empty() || bound(nodes[0]) > limit) return Descent::go_on;
  std::array<space::Keyed<Key>, most_tree_depth> later;
  std::size_t waiting = 0;
  for (std::uint32_t i = 0;;) {
    const auto& node = nodes[i];
    if (!node.is_leaf()) {
      space::Keyed<Key> near{bound(nodes[i + 1]), i + 1}, far{bound(nodes[i + node.link]), i + node.link};
      if (far.key < near.key) std::swap(near, far);
      if (!(near.key > limit)) {
        if (!(far.key > limit)) later[waiting++] = far;
        i = near.node;
        continue;
      }
    } else if (space::visited(visit, node.link, node.count, limit) == Descent::stop) {
      return Descent::stop;
    }
    do {
      if (waiting == 0) return Descent::go_on;
      --waiting;
    } while (later[waiting].key > limit);
    i = later[waiting].node;
  }
}

template <class Tree, class Key, class Bound, class Visit>
Descent descend_nearest_first(const Tree& tree, Key& limit, Bound&& bound, Visit&& visit) {
  const auto nodes = tree.nodes.view();
  if (nodes.empty()) return Descent::go_on;
  using Keyed = space::Keyed<Key>;
  const auto farther = [](const Keyed& a, const Keyed& b) {
    return b.key < a.key || (!(a.key < b.key) && b.node < a.node);
  };
  std::priority_queue<Keyed, std::vector<Keyed>, decltype(farther)> later(farther);
  later.push({bound(nodes[0]), 0});
  while (!later.empty() && !(later.top().key > limit)) {
    const std::uint32_t i = later.top().node;
    later.pop();
    const auto& node = nodes[i];
    if (node.is_leaf()) {
      if (space::visited(visit, node.link, node.count, limit) == Descent::stop) return Descent::stop;
      continue;
    }
    for (const std::uint32_t child : {i + 1, i + node.link}) {
      const Key key = bound(nodes[child]);
      if (!(key > limit)) later.push({key, child});
    }
  }
  return Descent::go_on;
}

}  // namespace plumb
