// How are two trees asked together?  Pairs of nodes, from the two roots on; a rule says which of a pair is descended.
//
//   descend_pairs(a, b, descend_larger{}, [&](const BoxNode& na, const BoxNode& nb) { return meet(na, nb); },
//                 [&](const BoxNode& leaf_a, const BoxNode& leaf_b) { ... });  // their slots are link and count
//   descend_own_pairs(tree, meets, visit);                                     // a tree with itself, each pair once
//
// A rule is called with two nodes, none of them a leaf, and says which to replace by its children.  Where one is a
// leaf, the other is.  A visit may return Descent::stop, or nothing.
// Laws: (1) each pair of leaves is visited at most once, and exactly if all pairs of nodes on the way to it meet.  What
//       meets keeps its answer for what contains more, so the pairs visited depend on no rule.  (2) Of a tree with
//       itself visit is called with the same leaf twice, and with each two leaves once, the first in the order of the
//       slots first.
// Where the frames of the trees differ (box_frame.hpp), so do the numbers of their boxes: `meets` must know.
// No recursion; a stack of fixed size.
// Source: RTCD 6.3.1, 6.3.3.
// Cost: one call of meets for each pair that a pair which meets is replaced by.
#pragma once

#include <utility>

#include "plumb/space/bvh/descend.hpp"

namespace plumb {

enum class Descend : unsigned char { first, second, both };

/// The first tree down to its leaves, then the second.
struct descend_first {
  template <class A, class B>
  Descend operator()(const A&, const B&) const {
    return Descend::first;
  }
};
/// The node of the longer diagonal; a guess in floats, of boxes in one frame.  Of volumes the one whose size() is larger.
struct descend_larger {
  static float size(const BoxNode& n) {
    const float x = n.max[0] - n.min[0], y = n.max[1] - n.min[1], z = n.max[2] - n.min[2];
    return x * x + y * y + z * z;
  }
  template <class Node>
  requires requires(const Node& n) { n.size(); }
  static auto size(const Node& n) { return n.size(); }
  template <class A, class B>
  Descend operator()(const A& a, const B& b) const {
    return size(a) < size(b) ? Descend::second : Descend::first;
  }
};
/// Both at once: four pairs.
struct descend_both {
  template <class A, class B>
  Descend operator()(const A&, const B&) const {
    return Descend::both;
  }
};

namespace space {

struct NodePair {
  std::uint32_t a, b;
};

// Pairs that wait: one for each level of a tree that is descended alone, three for a level of both.
inline constexpr std::size_t most_waiting_pairs = 3 * std::size_t{most_tree_depth} + 4;

/// What a pair is replaced by, the first to be looked at last: take(NodePair) of each.  Not of two leaves.
template <class A, class B, class Rule, class Take>
void replace_pair(std::span<const A> as, std::span<const B> bs, const Rule& rule, NodePair pair, const Take& take) {
  const auto [i, k] = pair;
  const A& a = as[i];
  const B& b = bs[k];
  const Descend which = a.is_leaf() ? Descend::second : b.is_leaf() ? Descend::first : rule(a, b);
  if (which == Descend::first) {
    take({i + a.link, k});
    take({i + 1, k});
  } else if (which == Descend::second) {
    take({i, k + b.link});
    take({i, k + 1});
  } else {
    take({i + a.link, k + b.link});
    take({i + a.link, k + 1});
    take({i + 1, k + b.link});
    take({i + 1, k + 1});
  }
}

/// The same of one tree, in which a node is paired with itself as well.
template <class Node, class Take>
void replace_own_pair(std::span<const Node> nodes, NodePair pair, const Take& take) {
  const auto [i, k] = pair;
  if (i != k) {
    replace_pair(nodes, nodes, descend_larger{}, pair, take);
  } else {
    const std::uint32_t second = i + nodes[i].link;
    take({i + 1, second});
    take({second, second});
    take({i + 1, i + 1});
  }
}

/// From one pair on; replace(pair, take) says what it is replaced by.
template <class A, class B, class Replace, class Meets, class Visit>
Descent descend_from(std::span<const A> as, std::span<const B> bs, NodePair start, const Replace& replace, Meets& meets,
                     Visit& visit) {
  std::array<NodePair, most_waiting_pairs> later;
  std::size_t waiting = 0;
  later[waiting++] = start;
  while (waiting > 0) {
    const NodePair pair = later[--waiting];
    const A& a = as[pair.a];
    const B& b = bs[pair.b];
    if (!a.is_leaf() || !b.is_leaf()) {
      replace(pair, [&](NodePair next) {
        if (meets(as[next.a], bs[next.b])) later[waiting++] = next;
      });
    } else if (visited(visit, a, b) == Descent::stop) {
      return Descent::stop;
    }
  }
  return Descent::go_on;
}

}  // namespace space

template <class TreeA, class TreeB, class Rule, class Meets, class Visit>
Descent descend_pairs(const TreeA& tree_a, const TreeB& tree_b, const Rule& rule, Meets&& meets, Visit&& visit) {
  const auto as = tree_a.nodes.view();
  const auto bs = tree_b.nodes.view();
  if (as.empty() || bs.empty() || !meets(as[0], bs[0])) return Descent::go_on;
  const auto replace = [&](space::NodePair pair, const auto& take) { space::replace_pair(as, bs, rule, pair, take); };
  return space::descend_from(as, bs, {0, 0}, replace, meets, visit);
}

/// A node always meets itself.
template <class Tree, class Meets, class Visit>
Descent descend_own_pairs(const Tree& tree, Meets&& meets, Visit&& visit) {
  const auto nodes = tree.nodes.view();
  if (nodes.empty()) return Descent::go_on;
  const auto replace = [&](space::NodePair pair, const auto& take) { space::replace_own_pair(nodes, pair, take); };
  const auto itself_too = [&](const auto& a, const auto& b) { return &a == &b || meets(a, b); };
  return space::descend_from(nodes, nodes, {0, 0}, replace, itself_too, visit);
}

}  // namespace plumb
