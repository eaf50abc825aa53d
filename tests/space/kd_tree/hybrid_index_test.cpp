// Grids of trees and trees of grids: every answer against each box asked, on every kind of set, whatever the options.
#include "plumb/space/textbook/hybrid_index.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "plumb/space/pairs/brute_force_pairs.hpp"
#include "space/pairs/box_scenes.hpp"

namespace plumb {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// What the sets are known by: how much there was to be told, and by which parts.
struct Counts {
  std::size_t pairs = 0, touching = 0, in_boxes = 0, crowded = 0, lists = 0, twice = 0;
};

template <class Index>
std::vector<BoxPair> sorted_pairs(const Index& index, const BoxPairOptions& options) {
  auto pairs = overlapping_pairs(index, options);
  std::ranges::sort(pairs);
  return pairs;
}

template <class Index, class Box>
void expect_as_brute_force(const Index& index, const std::vector<Box>& boxes, const std::vector<Box>& asked,
                           Counts& counts) {
  const auto all = brute_force_pairs(std::span<const Box>(boxes));
  const auto over = brute_force_pairs(std::span<const Box>(boxes), {.touching = false});
  ASSERT_EQ(sorted_pairs(index, {}), all);
  ASSERT_EQ(sorted_pairs(index, {.touching = false}), over);
  ASSERT_EQ(overlapping_pairs(index), overlapping_pairs(index, {.execution = Execution::serial}));
  counts.pairs += all.size(), counts.touching += all.size() - over.size();
  for (const Box& box : asked) {
    Numbers meeting, over_box;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      const Relation r = relate(boxes[i], box);
      if (r != Relation::disjoint) meeting.push_back(i);
      if (r == Relation::overlapping) over_box.push_back(i);
    }
    ASSERT_EQ(in_box(index, box), meeting);
    ASSERT_EQ(in_box(index, box, {.touching = false}), over_box);
    counts.in_boxes += meeting.size();
  }
  counts.crowded += index.crowded.indexes.size();
  counts.lists += index.crowded.index_of.size() - index.crowded.indexes.size();
}

template <class Box>
void expect_hybrids(const std::vector<Box>& boxes, const std::vector<Box>& asked, Entropy& e, Counts& grids,
                    Counts& trees) {
  HybridOptions options{.in_part = static_cast<std::uint32_t>(1 + e.below(24)),
                        .most_in_list = static_cast<std::uint32_t>(e.below(12))};
  const auto tree = build_tree_of_grids(boxes, options);
  ASSERT_NO_FATAL_FAILURE(expect_as_brute_force(tree, boxes, asked, trees));
  trees.twice += tree.tree.items.size() - boxes.size();
  const auto grid = build_grid_of_trees(boxes, options);
  ASSERT_NO_FATAL_FAILURE(expect_as_brute_force(grid, boxes, asked, grids));
  grids.twice += grid.grid.entries() - boxes.size();
}

TEST(HybridIndexes, AnswerAsEachBoxDoes) {
  Counts grids, trees;
  const std::size_t rounds = battery::fitting(18u);
  for (int s = 0; s <= static_cast<int>(box_scenes::last_scene); ++s) {
    for (std::size_t round = 0; round < rounds; ++round) {
      Entropy e(7381, static_cast<std::uint64_t>(s) * 1000 + round);
      SCOPED_TRACE(testing::Message() << "start 7381 index " << s * 1000 + static_cast<int>(round));
      const auto scene = static_cast<box_scenes::Scene>(s);
      const auto boxes = box_scenes::boxes_of(scene, e, 1 + e.below(120));
      auto asked = box_scenes::boxes_of(scene, e, 6);
      asked.push_back(boxes[e.below(boxes.size())]);
      if (round % 2 == 0) {
        ASSERT_NO_FATAL_FAILURE(expect_hybrids(boxes, asked, e, grids, trees));
      } else {
        ASSERT_NO_FATAL_FAILURE(
            expect_hybrids(box_scenes::in_the_plane(boxes), box_scenes::in_the_plane(asked), e, grids, trees));
      }
    }
  }
  for (const Counts& counts : {grids, trees}) {
    EXPECT_GT(counts.pairs, battery::fitting(20'000u));
    EXPECT_GT(counts.touching, battery::fitting(1000u));
    EXPECT_GT(counts.in_boxes, battery::fitting(2000u));
    EXPECT_GT(counts.crowded, battery::fitting(300u));
    EXPECT_GT(counts.lists, battery::fitting(300u));
    EXPECT_GT(counts.twice, battery::fitting(1000u));
  }
}

TEST(HybridIndexes, AreTheSameOnEveryNumberOfThreads) {
  Entropy e(7382, 0);
  const auto boxes = box_scenes::boxes_of(box_scenes::Scene::clustered, e, battery::fitting(3000u));
  const HybridOptions serial{.in_part = 64, .execution = Execution::serial}, parallel{.in_part = 64};
  const auto grid = build_grid_of_trees(boxes, serial);
  EXPECT_EQ(overlapping_pairs(build_grid_of_trees(boxes, parallel)), overlapping_pairs(grid));
  EXPECT_GT(grid.crowded.indexes.size(), 2u);
  const auto tree = build_tree_of_grids(boxes, serial);
  EXPECT_EQ(overlapping_pairs(build_tree_of_grids(boxes, parallel)), overlapping_pairs(tree));
  EXPECT_GT(tree.crowded.indexes.size(), battery::reaches_rare ? 20u : 0u);
  EXPECT_EQ(sorted_pairs(tree, {}), sorted_pairs(grid, {}));
  EXPECT_GT(memory_of(grid), 2 * sizeof(Aabb3) * boxes.size());
  EXPECT_GT(memory_of(tree), 2 * sizeof(Aabb3) * boxes.size());
}

TEST(HybridIndexes, RefuseByName) {
  using ::testing::HasSubstr;
  EXPECT_TRUE(in_box(build_grid_of_trees(std::vector<Aabb2>{}), {{0, 0}, {1, 1}}).empty());
  EXPECT_TRUE(in_box(build_tree_of_grids(std::vector<Aabb3>{}), {{0, 0, 0}, {1, 1, 1}}).empty());
  EXPECT_TRUE(overlapping_pairs(build_grid_of_trees(std::vector<Aabb3>{})).empty());
  EXPECT_TRUE(overlapping_pairs(build_tree_of_grids(std::vector<Aabb2>{})).empty());
  const double nan = std::nan("");
  const std::vector<Aabb2> one{{{0, 0}, {1, 1}}}, bad{{{0, 0}, {1, 1}}, {{0, nan}, {1, 1}}}, empty{{{1, 0}, {0, 1}}};
  const auto grid = build_grid_of_trees(one);
  const auto tree = build_tree_of_grids(one);
  EXPECT_TRUE(in_box(grid, {{1, 1}, {0, 0}}).empty());
  EXPECT_TRUE(in_box(tree, {{1, 1}, {0, 0}}).empty());
  const auto asked = [&](const auto& index) {
    return text_of<NonFinite>([&] { (void)in_box(index, {{0, 0}, {1, nan}}); });
  };
  EXPECT_THAT(asked(grid), HasSubstr("in_box: box.max.y is nan"));
  EXPECT_THAT(asked(tree), HasSubstr("in_box: box.max.y is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] { (void)build_grid_of_trees(bad); }),
              HasSubstr("build_grid_of_trees: boxes[1].min.y is nan"));
  EXPECT_THAT(text_of<NonFinite>([&] { (void)build_tree_of_grids(bad); }),
              HasSubstr("build_tree_of_grids: boxes[1].min.y is nan"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)build_grid_of_trees(empty); }),
              HasSubstr("build_grid_of_trees: boxes[0] is empty; leave it out"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)build_tree_of_grids(one, {.in_part = 0}); }),
              HasSubstr("build_tree_of_grids: options.in_part is 0, but it must be at least 1"));
  EXPECT_THAT(text_of<InvalidShape>([&] { (void)build_grid_of_trees(one, {.grid = {.cell_size = 0}}); }),
              HasSubstr("build_grid_of_trees: options.cell_size is not above zero"));
  EXPECT_THAT(text_of<Error>([&] { (void)build_grid_of_trees(one, {.grid = {.cell_size = 1e-9}}); }),
              HasSubstr("options.most_memory is"));
}

}  // namespace
}  // namespace plumb
