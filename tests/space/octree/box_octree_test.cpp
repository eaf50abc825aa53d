// Are the pairs those of brute force, by either rule, and the boxes in a region?
#include "plumb/space/octree/box_octree.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "space/octree/octree_laws.hpp"
#include "space/octree/scenes.hpp"

namespace plumb {
namespace {

template <std::size_t D>
auto built(const std::vector<typename CellKinds<D>::Box>& boxes, const BoxOctreeOptions& options) {
  if constexpr (D == 2) {
    return build_quadtree(boxes, options);
  } else {
    return build_octree(boxes, options);
  }
}

template <class Box>
std::vector<BoxPair> by_brute_force(const std::vector<Box>& boxes, bool touching) {
  std::vector<BoxPair> pairs;
  for (std::uint32_t a = 0; a < boxes.size(); ++a) {
    for (std::uint32_t b = a + 1; b < boxes.size(); ++b) {
      const Relation r = relate(boxes[a], boxes[b]);
      if (r == Relation::overlapping || (touching && r == Relation::touching)) pairs.push_back({a, b});
    }
  }
  return pairs;
}

template <class Dimension>
class BoxTrees : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<std::size_t, 2>, std::integral_constant<std::size_t, 3>>;
TYPED_TEST_SUITE(BoxTrees, Dimensions);

TYPED_TEST(BoxTrees, PairsAreThoseOfBruteForce) {
  constexpr std::size_t D = TypeParam::value;
  std::size_t touching = 0, overlapping = 0, inner = 0, cut = 0, at_border = 0;
  scenes::on_scenes(
      741 + D, battery::sanitized ? 3 : 14, [&](scenes::Family family, Entropy& e, const std::string& text) {
        const auto boxes = scenes::boxes_of<D>(family, 1 + e.below(70), e);
        BoxOctreeOptions options;
        options.most_in_leaf = static_cast<std::uint32_t>(1 + e.below(5));
        if (e.coin()) options.most_depth = static_cast<std::uint32_t>(e.below(6));
        if (e.coin()) options.most_references = static_cast<double>(1 + e.below(4));
        const auto all = by_brute_force(boxes, true), beyond = by_brute_force(boxes, false);
        overlapping += beyond.size(), touching += all.size() - beyond.size();
        for (const CellRule rule : {CellRule::smallest_cell, CellRule::every_leaf}) {
          options.rule = rule;
          const auto tree = built<D>(boxes, options);
          ASSERT_EQ(octree_laws::broken(tree.cells, options.most_depth), "") << text;
          EXPECT_LE(tree.cells.items.size(), options.most_references * static_cast<double>(boxes.size())) << text;
          for (std::size_t i = 0; i < tree.boxes.size(); ++i)
            EXPECT_EQ(tree.boxes[i], boxes[tree.cells.items[i]]) << text;
          cut += tree.cells.nodes.size() > 1 ? 1 : 0;
          std::vector<std::size_t> seen(boxes.size());
          for (std::uint32_t node = 0; node < tree.cells.nodes.size(); ++node) {
            const auto cell = box_of(tree.cells, node);
            const OwnItems own = own_items(tree.cells, node);
            inner += tree.cells.nodes[node].is_leaf() ? 0 : own.end - own.begin;
            for (std::uint32_t i = own.begin; i < own.end; ++i) {
              ++seen[tree.cells.items[i]];
              if (rule == CellRule::every_leaf) {
                EXPECT_TRUE(tree.cells.nodes[node].is_leaf()) << text;
                EXPECT_TRUE(octree_laws::has_place_in(cell, tree.boxes[i])) << text;
              } else {
                EXPECT_TRUE(octree_laws::is_in_cell(cell, tree.boxes[i].min) &&
                            octree_laws::is_in_cell(cell, tree.boxes[i].max))
                    << text;
              }
            }
          }
          for (const std::size_t count : seen)
            EXPECT_TRUE(rule == CellRule::every_leaf ? count >= 1 : count == 1) << text;
          for (const bool with_touching : {true, false}) {
            auto pairs = overlapping_pairs(tree, {.touching = with_touching});
            EXPECT_EQ(pairs, overlapping_pairs(tree, {.touching = with_touching, .execution = Execution::serial}))
                << text;
            std::sort(pairs.begin(), pairs.end());
            EXPECT_EQ(pairs, with_touching ? all : beyond) << text;
          }
          for (int k = 0; k < 3; ++k) {
            const auto box = scenes::box_of<D>(family, e);
            std::vector<std::uint32_t> expected, over;
            for (std::uint32_t i = 0; i < boxes.size(); ++i) {
              const Relation r = relate(box, boxes[i]);
              if (r != Relation::disjoint) expected.push_back(i);
              if (r == Relation::overlapping) over.push_back(i);
            }
            EXPECT_EQ(in_box(tree, box), expected) << text;
            EXPECT_EQ(in_box(tree, box, {.touching = false}), over) << text;
            at_border += expected.size() - over.size();
          }
        }
      });
  EXPECT_GT(touching, 200u);
  EXPECT_GT(overlapping, 200u);
  EXPECT_GT(inner, 200u);
  EXPECT_GT(at_border, battery::sanitized ? 10u : 50u);
  EXPECT_GT(cut, battery::sanitized ? 20u : 50u);
}

TYPED_TEST(BoxTrees, AreTheSameOnAnyNumberOfThreads) {
  constexpr std::size_t D = TypeParam::value;
  for (const scenes::Family family : {scenes::Family::uniform, scenes::Family::lattice, scenes::Family::sizes}) {
    Entropy e(751, static_cast<std::uint64_t>(family));
    auto boxes = scenes::boxes_of<D>(family, battery::sanitized ? 500 : 3'000, e);
    for (const CellRule rule : {CellRule::smallest_cell, CellRule::every_leaf}) {
      const auto serial = built<D>(boxes, {.rule = rule, .execution = Execution::serial});
      const auto pairs = overlapping_pairs(serial, {.execution = Execution::serial});
      for (const std::size_t threads : {1u, 2u}) {
        const ThreadLimit control(threads);
        const auto tree = built<D>(boxes, {.rule = rule});
        EXPECT_EQ(tree.cells, serial.cells);
        EXPECT_EQ(overlapping_pairs(tree), pairs);
      }
    }
  }
}

// All in one place: no cell is cut in vain, and boxes that are everywhere are listed no oftener than is allowed.
TYPED_TEST(BoxTrees, EqualBoxesAreListedOnce) {
  constexpr std::size_t D = TypeParam::value;
  typename CellKinds<D>::Box unit{};
  unit.max.x = unit.max.y = 1;
  const std::vector<typename CellKinds<D>::Box> boxes(100'000, unit);
  const auto tree = built<D>(boxes, {.rule = CellRule::every_leaf});
  EXPECT_EQ(tree.cells.items.size(), boxes.size());
  EXPECT_EQ(built<D>(boxes, {}).cells.nodes.size(), 1u);
  EXPECT_EQ(in_box(tree, unit).size(), boxes.size());
}

TEST(BoxOctree, RefusesWhatIsNoBox) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto with = [](const Aabb3& second) { return std::vector<Aabb3>{{{0, 0, 0}, {1, 1, 1}}, second}; };
  EXPECT_THAT(text_of<NonFinite>([&] {
                (void)build_octree(with({{0, 0, 0}, {1, nan, 1}}));
              }),
              ::testing::HasSubstr("build_octree: boxes[1].max.y is nan"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                (void)build_octree(with({{0, 0, 2}, {1, 1, 1}}));
              }),
              ::testing::HasSubstr("build_octree: boxes[1] is empty"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)build_octree(with({}), {.most_references = 0.5}); }),
              ::testing::HasSubstr("options.most_references is 0.5"));
  EXPECT_TRUE(overlapping_pairs(build_octree(std::vector<Aabb3>{})).empty());
  EXPECT_TRUE(in_box(build_octree(with({})), Aabb3{{1, 0, 0}, {0, 0, 0}}).empty());
}

}  // namespace
}  // namespace plumb
