// Are the numbers of a tree those of its boxes, and do they tell good trees from bad ones?
#include "plumb/space/bvh/tree_cost.hpp"

#include <gtest/gtest.h>

#include <map>

#include "space/bvh/meshes.hpp"
#include "space/bvh/tree_laws.hpp"

namespace plumb {
namespace {

TEST(TreeCost, OfATreeByHand) {
  // A unit cube's halves, one of them with two items.
  const std::vector<Aabb3> boxes{{{0, 0, 0}, {0.5, 1, 1}}, {{0.5, 0, 0}, {1, 1, 1}}, {{0.5, 0, 0}, {1, 1, 1}}};
  const BoxTree tree = build_box_tree(boxes, {.most_in_leaf = 2, .item_cost = 8});
  const TreeCost cost = cost_of(tree);
  EXPECT_EQ(cost.nodes, 3u);
  EXPECT_EQ(cost.leaves, 2u);
  EXPECT_EQ(cost.depth, 1u);
  EXPECT_EQ(cost.most_in_leaf, 2u);
  EXPECT_DOUBLE_EQ(cost.mean_depth, 1);
  EXPECT_DOUBLE_EQ(cost.nodes_met, 1 + 2.0 / 3 + 2.0 / 3);  // half areas 3, 2 and 2
  EXPECT_DOUBLE_EQ(cost.items_met, 3 * 2.0 / 3);
  EXPECT_DOUBLE_EQ(cost.total(1, 0.5), 1 + 4.0 / 3 + 1);
}

TEST(TreeCost, OfLittle) {
  EXPECT_EQ(cost_of(BoxTree{}).nodes, 0u);
  const TreeCost point = cost_of(build_box_tree(std::vector<Aabb3>{{{1, 1, 1}, {1, 1, 1}}}));
  EXPECT_EQ(point.nodes_met, 1);
  EXPECT_EQ(point.items_met, 1);
}

// What each builder is for: sweeps cost least of those that cut, whole areas less than single places.
TEST(TreeCost, OrdersTheBuilders) {
  const std::vector<Aabb3> boxes = tree_laws::boxes_of(meshes::ring(40));
  std::map<BvhMethod, double> cost;
  for (const BvhMethod method : bvh_methods) {
    const TreeCost c = cost_of(build_box_tree(boxes, {.method = method}));
    cost[method] = c.total(1, 0.5);
    RecordProperty(std::string(name_of(method)), std::to_string(cost[method]));
    EXPECT_LE(c.depth, most_tree_depth);
  }
  EXPECT_LT(cost[BvhMethod::sweep], cost[BvhMethod::binned] * 1.02);
  for (const BvhMethod method : {BvhMethod::object_median, BvhMethod::object_mean, BvhMethod::spatial_median,
                                 BvhMethod::linear, BvhMethod::insertion}) {
    EXPECT_GT(cost[method], cost[BvhMethod::binned]) << name_of(method);
  }
}

TEST(TreeCost, ChainsAreAsDeepAsTreesMayBe) {
  const std::vector<Aabb3> boxes = tree_laws::boxes_of(meshes::doubling(600, -1000, 3));
  EXPECT_LE(cost_of(build_box_tree(boxes, {.most_in_leaf = 1})).depth, most_tree_depth);
}

}  // namespace
}  // namespace plumb
