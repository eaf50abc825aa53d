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
//       descent first; in binary trees that is the order of the slots.
// Where the frames of the trees differ (box_frame.hpp), so do the numbers of their boxes: `meets` must know.
// A tree of another layout takes part once TreePlaces says how its places are named (descend_compact_pairs.hpp).
// No recursion; a stack of fixed size.
// Source: RTCD 6.3.1, 6.3.3.
// Cost: one call of meets for each pair that a pair which meets is replaced by.  Bounded by n^2 calls for n nodes of
// both.
#pragma once

#include <array>
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

/// Of two trees, how their nodes are named: binary ones by their numbers.
template <class A, class B>
struct PlacePair {
  A a;
  B b;
};
template <class A, class B>
PlacePair(A, B) -> PlacePair<A, B>;
using NodePair = PlacePair<std::uint32_t, std::uint32_t>;

// What a descent must know of a tree: empty(), the node at a place, whose is_leaf() is asked, and the following.
template <class Node>
std::uint32_t root_place(std::span<const Node>) {
  return 0;
}
/// take(place) of each child, the first last.
template <class Node, class Take>
void for_children(std::span<const Node> nodes, std::uint32_t i, const Take& take) {
  take(i + nodes[i].link);
  take(i + 1);
}
template <class Node>
bool is_same_node(std::span<const Node>, const Node& a, const Node& b) {
  return &a == &b;
}
template <class Node>
bool is_same_place(std::span<const Node>, std::uint32_t i, std::uint32_t k) {
  return i == k;
}

/// So many children has a node at most, and so many levels a tree.
template <class Places>
inline constexpr std::size_t most_children = 2;
template <class Places>
inline constexpr std::size_t most_levels = most_tree_depth;

// Pairs that wait: a pair is replaced by one for each two children, and then the next level of both is looked at.
template <class As, class Bs>
inline constexpr std::size_t most_pairs_waiting = [] {
  const std::size_t levels = most_levels<As> < most_levels<Bs> ? most_levels<Bs> : most_levels<As>;
  return (most_children<As> * most_children<Bs> - 1) * levels + 4;
}();
inline constexpr std::size_t most_waiting_pairs =
    most_pairs_waiting<std::span<const BoxNode>, std::span<const BoxNode>>;

/// What a pair is replaced by, the first to be looked at last: take(pair) of each.  Not of two leaves.
template <class As, class Bs, class Rule, class A, class B, class Take>
void replace_pair(const As& as, const Bs& bs, const Rule& rule, const PlacePair<A, B>& pair, const Take& take) {
  using Pair = PlacePair<A, B>;
  const auto& a = as[pair.a];
  const auto& b = bs[pair.b];
  const Descend which = a.is_leaf() ? Descend::second : b.is_leaf() ? Descend::first : rule(a, b);
  if (which == Descend::first) {
    for_children(as, pair.a, [&](const A& i) { take(Pair{i, pair.b}); });
  } else if (which == Descend::second) {
    for_children(bs, pair.b, [&](const B& k) { take(Pair{pair.a, k}); });
  } else {
    for_children(as, pair.a, [&](const A& i) { for_children(bs, pair.b, [&](const B& k) { take(Pair{i, k}); }); });
  }
}

/// The same of one tree, in which a node is paired with itself as well.
template <class Places, class A, class Rule, class Take>
void replace_own_pair(const Places& places, const PlacePair<A, A>& pair, const Rule& rule, const Take& take) {
  using Pair = PlacePair<A, A>;
  if (!is_same_place(places, pair.a, pair.b)) return replace_pair(places, places, rule, pair, take);
  std::array<A, most_children<Places>> last_first;
  std::size_t n = 0;
  for_children(places, pair.a, [&](const A& child) { last_first[n++] = child; });
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = k + 1; i < n; ++i) take(Pair{last_first[i], last_first[k]});
  }
  for (std::size_t i = 0; i < n; ++i) take(Pair{last_first[i], last_first[i]});
}

template <class Places, class A, class Take>
void replace_own_pair(const Places& places, const PlacePair<A, A>& pair, const Take& take) {
  replace_own_pair(places, pair, descend_larger{}, take);
}

/// From one pair on; replace(pair, take) says what it is replaced by.
template <class As, class Bs, class A, class B, class Replace, class Meets, class Visit>
Descent descend_from(const As& as, const Bs& bs, const PlacePair<A, B>& start, const Replace& replace, Meets& meets,
                     Visit& visit) {
  using Pair = PlacePair<A, B>;
  std::array<Pair, most_pairs_waiting<As, Bs>> later;
  std::size_t waiting = 0;
  later[waiting++] = start;
  while (waiting > 0) {
    const Pair pair = later[--waiting];
    const auto& a = as[pair.a];
    const auto& b = bs[pair.b];
    if (!a.is_leaf() || !b.is_leaf()) {
      replace(pair, [&](const Pair& next) {
        if (meets(as[next.a], bs[next.b])) later[waiting++] = next;
      });
    } else if (visited(visit, a, b) == Descent::stop) {
      return Descent::stop;
    }
  }
  return Descent::go_on;
}

/// How the nodes of a tree are found.
template <class Tree>
struct TreePlaces {
  static auto of(const Tree& tree) { return tree.nodes.view(); }
};

}  // namespace space

template <class TreeA, class TreeB, class Rule, class Meets, class Visit>
Descent descend_pairs(const TreeA& tree_a, const TreeB& tree_b, const Rule& rule, Meets&& meets, Visit&& visit) {
  const auto as = space::TreePlaces<TreeA>::of(tree_a);
  const auto bs = space::TreePlaces<TreeB>::of(tree_b);
  if (as.empty() || bs.empty()) return Descent::go_on;
  using space::root_place;
  const space::PlacePair roots{root_place(as), root_place(bs)};
  if (!meets(as[roots.a], bs[roots.b])) return Descent::go_on;
  const auto replace = [&](const auto& pair, const auto& take) { space::replace_pair(as, bs, rule, pair, take); };
  return space::descend_from(as, bs, roots, replace, meets, visit);
}

/// A node always meets itself.
template <class Tree, class Meets, class Visit>
Descent descend_own_pairs(const Tree& tree, Meets&& meets, Visit&& visit) {
  const auto places = space::TreePlaces<Tree>::of(tree);
  if (places.empty()) return Descent::go_on;
  const auto replace = [&](const auto& pair, const auto& take) { space::replace_own_pair(places, pair, take); };
  using space::is_same_node, space::root_place;
  const auto itself_too = [&](const auto& a, const auto& b) { return is_same_node(places, a, b) || meets(a, b); };
  return space::descend_from(places, places, space::PlacePair{root_place(places), root_place(places)}, replace,
                             itself_too, visit);
}

}  // namespace plumb
