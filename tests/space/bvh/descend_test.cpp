// Do descents visit what they must and nothing else: each leaf, or pair of leaves, that all above it let through?
#include "plumb/space/bvh/descend.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "plumb/space/bvh/descend_pairs.hpp"
#include "space/bvh/meshes.hpp"
#include "space/bvh/tree_laws.hpp"

namespace plumb {
namespace {

using tree_laws::boxes_of;
using Slots = std::vector<std::uint32_t>;

bool meet(const BoxNode& a, const BoxNode& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (a.max[k] < b.min[k] || b.max[k] < a.min[k]) return false;
  }
  return true;
}

BoxNode around(const BoxFrame& frame, const Aabb3& box) {
  const FloatBox3 f = frame.around(box);
  return {f.min, 0, f.max, 0};
}

/// The leaves, by brute force.
std::vector<BoxNode> leaves_of(const BoxTree& tree) {
  std::vector<BoxNode> leaves;
  for (const BoxNode& node : tree.nodes) {
    if (node.is_leaf()) leaves.push_back(node);
  }
  return leaves;
}

BoxTree tree_of(shape_cases::Material& m) {
  return build_box_tree(boxes_of(meshes::soup(m, 1 + m.below(40), m.below(80))),
                        {.most_in_leaf = static_cast<std::uint32_t>(1 + m.below(4))});
}

TEST(Descend, VisitsTheLeavesThatMeet) {
  std::size_t met = 0, all = 0;
  shape_cases::on_shapes(921, 300, [&](shape_cases::Material& m) {
    const BoxTree tree = tree_of(m);
    const BoxNode box = around(tree.frame, {m.point3(), m.point3()});
    Slots expected, visited;
    for (const BoxNode& leaf : leaves_of(tree)) {
      ++all;
      if (meet(leaf, box)) expected.push_back(leaf.link);
    }
    const Descent all_of_it = descend(
        tree, [&](const BoxNode& node) { return meet(node, box); },
        [&](std::uint32_t first, std::uint32_t count) {
          EXPECT_GT(count, 0u);
          visited.push_back(first);
        });
    EXPECT_EQ(all_of_it, Descent::go_on);
    EXPECT_EQ(visited, expected);
    met += visited.size();
    std::size_t calls = 0;
    const Descent stopped = descend(
        tree, [&](const BoxNode& node) { return meet(node, box); },
        [&](std::uint32_t, std::uint32_t) { return ++calls == 2 ? Descent::stop : Descent::go_on; });
    EXPECT_EQ(stopped == Descent::stop, expected.size() >= 2);
    EXPECT_EQ(calls, std::min<std::size_t>(expected.size(), 2));
  });
  EXPECT_GT(met, 500u);
  EXPECT_GT(all - met, 500u);
}

// The least distance along x from a place: of a node, of its children, of the least item.
float beyond(const BoxNode& node, float x) { return std::max({0.0F, node.min[0] - x, x - node.max[0]}); }

void finds_the_nearest(std::uint64_t start, bool sorted) {
  shape_cases::on_shapes(start, 300, [&](shape_cases::Material& m) {
    const BoxTree tree = tree_of(m);
    const float x = tree.frame.below(m.point3().x);
    if (!(std::abs(x) < 1e30F)) return;
    constexpr float infinity = std::numeric_limits<float>::infinity();
    float limit = infinity, least = infinity;
    std::vector<float> bounds(tree.items.size(), infinity);
    for (const BoxNode& leaf : leaves_of(tree)) least = std::min(least, bounds[leaf.link] = beyond(leaf, x));
    std::vector<float> order;
    std::set<std::uint32_t> visited;
    const auto bound = [&](const BoxNode& node) { return beyond(node, x); };
    const auto visit = [&](std::uint32_t first, std::uint32_t, float& now) {
      EXPECT_TRUE(visited.insert(first).second);
      EXPECT_LE(bounds[first], now);
      order.push_back(bounds[first]);
      now = std::min(now, bounds[first]);
    };
    if (sorted) {
      EXPECT_EQ(descend_nearest_first(tree, limit, bound, visit), Descent::go_on);
      EXPECT_TRUE(std::is_sorted(order.begin(), order.end()));
    } else {
      EXPECT_EQ(descend_nearer_first(tree, limit, bound, visit), Descent::go_on);
    }
    EXPECT_EQ(limit, least);
    for (const BoxNode& leaf : leaves_of(tree)) {
      EXPECT_TRUE(bounds[leaf.link] > least || visited.contains(leaf.link));
    }
  });
}

TEST(DescendNearerFirst, ReachesAllThatTie) { finds_the_nearest(922, false); }
TEST(DescendNearestFirst, ReachesAllThatTieInOrder) { finds_the_nearest(923, true); }

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

TEST(DescendPairs, VisitsTheSamePairsByEveryRule) {
  std::size_t met = 0, apart = 0;
  shape_cases::on_shapes(924, 200, [&](shape_cases::Material& m) {
    const BoxTree a = tree_of(m), b = tree_of(m);
    Pairs expected;
    for (const BoxNode& x : leaves_of(a)) {
      for (const BoxNode& y : leaves_of(b)) {
        if (meet(x, y)) expected.insert({x.link, y.link});
        ++(meet(x, y) ? met : apart);
      }
    }
    const auto check = [&](const auto& rule) {
      Pairs visited;
      descend_pairs(a, b, rule, meet, [&](const BoxNode& x, const BoxNode& y) {
        EXPECT_TRUE(visited.insert({x.link, y.link}).second);
      });
      EXPECT_EQ(visited, expected);
    };
    check(descend_first{});
    check(descend_larger{});
    check(descend_both{});
    check([](const BoxNode&, const BoxNode&) { return Descend::second; });  // a user's
    std::size_t calls = 0;
    const Descent stopped = descend_pairs(a, b, descend_larger{}, meet, [&](const BoxNode&, const BoxNode&) {
      return ++calls == 2 ? Descent::stop : Descent::go_on;
    });
    EXPECT_EQ(stopped == Descent::stop, expected.size() >= 2);
  });
  EXPECT_GT(met, 1000u);
  EXPECT_GT(apart, 1000u);
}

TEST(DescendOwnPairs, VisitsEachPairOnce) {
  shape_cases::on_shapes(925, 200, [&](shape_cases::Material& m) {
    const BoxTree tree = tree_of(m);
    const std::vector<BoxNode> leaves = leaves_of(tree);
    Pairs expected, visited;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      for (std::size_t k = i; k < leaves.size(); ++k) {
        if (meet(leaves[i], leaves[k])) expected.insert({leaves[i].link, leaves[k].link});
      }
    }
    descend_own_pairs(tree, meet, [&](const BoxNode& x, const BoxNode& y) {
      EXPECT_TRUE(visited.insert({x.link, y.link}).second);
    });
    EXPECT_EQ(visited, expected);
  });
}

// As deep as trees become, everything waiting at once.
TEST(Descend, HasRoomForTheDeepestTree) {
  const BoxTree tree = build_box_tree(boxes_of(meshes::doubling(600, -1000, 3)), {.most_in_leaf = 1});
  std::size_t leaves = 0, pairs = 0, own = 0;
  const auto always = [](const auto&...) { return true; };
  descend(tree, always, [&](std::uint32_t, std::uint32_t) { ++leaves; });
  EXPECT_EQ(leaves, 600u);
  for (int rule = 0; rule < 2; ++rule) {
    const auto count = [&](const BoxNode&, const BoxNode&) { ++pairs; };
    if (rule == 0) descend_pairs(tree, tree, descend_first{}, always, count);
    if (rule == 1) descend_pairs(tree, tree, descend_both{}, always, count);
  }
  EXPECT_EQ(pairs, 2u * 600 * 600);
  descend_own_pairs(tree, always, [&](const BoxNode&, const BoxNode&) { ++own; });
  EXPECT_EQ(own, 600u * 601 / 2);
}

}  // namespace
}  // namespace plumb
