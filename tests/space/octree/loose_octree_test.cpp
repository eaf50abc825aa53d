// Are the answers of a loose octree those of brute force, whatever was inserted, moved and removed?
#include "plumb/space/octree/loose_octree.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/figure/aabb/relation.hpp"
#include "space/octree/scenes.hpp"

namespace plumb {
namespace {

template <class Dimension>
class LooseTrees : public ::testing::Test {};
using Dimensions = ::testing::Types<std::integral_constant<std::size_t, 2>, std::integral_constant<std::size_t, 3>>;
TYPED_TEST_SUITE(LooseTrees, Dimensions);

TYPED_TEST(LooseTrees, AnswerAsBruteForceDoesAfterEveryFrame) {
  constexpr std::size_t D = TypeParam::value;
  using Box = typename CellKinds<D>::Box;
  std::size_t touching = 0, overlapping = 0, moved = 0, stayed = 0, removed = 0, at_border = 0;
  scenes::on_scenes(
      761 + D, battery::sanitized ? 2 : 8, [&](scenes::Family family, Entropy& e, const std::string& text) {
        LooseCells<D> tree(scenes::box_of<D>(family, e));
        std::vector<std::optional<Box>> boxes;
        std::size_t held = 0;
        for (int frame = 0; frame < 12; ++frame) {
          for (int change = 0; change < 8; ++change) {
            const Box box = scenes::box_of<D>(family, e);
            const auto handle = static_cast<std::uint32_t>(boxes.empty() ? 0 : e.below(boxes.size()));
            const bool is_held = !boxes.empty() && boxes[handle].has_value();
            if (const std::uint64_t what = e.below(4); what < 2 || !is_held) {
              const std::uint32_t made = tree.insert(box);
              ASSERT_TRUE(made == boxes.size() || (made < boxes.size() && !boxes[made])) << text;
              if (made == boxes.size()) boxes.emplace_back();
              boxes[made] = box;
              ++held;
            } else if (what == 2) {
              tree.remove(handle);
              boxes[handle].reset();
              --held, ++removed;
            } else {
              const std::uint64_t before = tree.code(handle);
              tree.move(handle, box);
              boxes[handle] = box;
              ++(tree.code(handle) == before ? stayed : moved);
            }
          }
          ASSERT_EQ(tree.size(), held) << text;
          std::vector<BoxPair> all, beyond;
          for (std::uint32_t a = 0; a < boxes.size(); ++a) {
            EXPECT_EQ(tree.contains(a), boxes[a].has_value()) << text;
            if (!boxes[a]) continue;
            EXPECT_EQ(tree.box(a), *boxes[a]) << text;
            for (std::uint32_t b = a + 1; b < boxes.size(); ++b) {
              const Relation r = boxes[b] ? relate(*boxes[a], *boxes[b]) : Relation::disjoint;
              if (r != Relation::disjoint) all.push_back({a, b});
              if (r == Relation::overlapping) beyond.push_back({a, b});
            }
          }
          EXPECT_EQ(tree.overlapping_pairs(), all) << text;
          EXPECT_EQ(tree.overlapping_pairs({.touching = false, .execution = Execution::serial}), beyond) << text;
          overlapping += beyond.size(), touching += all.size() - beyond.size();
          const Box region = scenes::box_of<D>(family, e);
          std::vector<std::uint32_t> expected, over;
          for (std::uint32_t a = 0; a < boxes.size(); ++a) {
            const Relation r = boxes[a] ? relate(*boxes[a], region) : Relation::disjoint;
            if (r != Relation::disjoint) expected.push_back(a);
            if (r == Relation::overlapping) over.push_back(a);
          }
          EXPECT_EQ(tree.in_box(region), expected) << text;
          EXPECT_EQ(tree.in_box(region, {.touching = false}), over) << text;
          at_border += expected.size() - over.size();
        }
        for (std::uint32_t a = 0; a < boxes.size(); ++a) {
          if (boxes[a]) tree.remove(a);
        }
        EXPECT_EQ(tree.cell_count(), 1u) << text;  // of the root alone
        EXPECT_TRUE(tree.overlapping_pairs().empty()) << text;
      });
  EXPECT_GT(touching, 200u);
  EXPECT_GT(overlapping, 200u);
  EXPECT_GT(moved, 50u);
  EXPECT_GT(at_border, battery::sanitized ? 10u : 50u);
  EXPECT_GT(stayed, 10u);
  EXPECT_GT(removed, 50u);
}

// A box across the middle of the world is in a small cell nevertheless.
TYPED_TEST(LooseTrees, SmallBoxesAreInSmallCells) {
  constexpr std::size_t D = TypeParam::value;
  typename CellKinds<D>::Box world{}, small{};
  world.min.x = world.min.y = -1, world.max.x = world.max.y = 1;
  LooseCells<D> tree(world);
  for (const double half : {0x1p-4, 0x1p-10, 0x1p-15}) {
    small.min.x = small.min.y = -half, small.max.x = small.max.y = half;
    const std::uint32_t handle = tree.insert(small);
    const double side =
        std::ldexp(tree.frame().unit(), static_cast<int>(CellFrame<D>::levels - level_of<D>(tree.code(handle))));
    EXPECT_LE(side, 2 * half);
    EXPECT_GE(side, half);
  }
}

TYPED_TEST(LooseTrees, ManyBoxesAreAnsweredAlikeByThreads) {
  constexpr std::size_t D = TypeParam::value;
  Entropy e(771);
  const auto boxes = scenes::boxes_of<D>(scenes::Family::uniform, battery::sanitized ? 300 : 1500, e);
  typename CellKinds<D>::Box world{};
  world.min.x = world.min.y = -1, world.max.x = world.max.y = 2;
  LooseCells<D> tree(world);
  for (const auto& box : boxes) tree.insert(box);
  const auto serial = tree.overlapping_pairs({.execution = Execution::serial});
  EXPECT_FALSE(serial.empty());
  for (const std::size_t threads : {1u, 2u}) {
    const ThreadLimit control(threads);
    EXPECT_EQ(tree.overlapping_pairs(), serial);
  }
}

TEST(LooseOctree, RefusesByNameAndStaysAsItWas) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  LooseOctree tree(Aabb3{{0, 0, 0}, {1, 1, 1}});
  const std::uint32_t handle = tree.insert({{0, 0, 0}, {1, 1, 1}});
  EXPECT_THAT(text_of<NonFinite>([&] {
                tree.insert({{0, nan, 0}, {1, 1, 1}});
              }),
              ::testing::HasSubstr("LooseOctree::insert: box.min.y is nan"));
  EXPECT_THAT(text_of<InvalidShape>([&] {
                tree.move(handle, {{0, 2, 0}, {1, 1, 1}});
              }),
              ::testing::HasSubstr("LooseOctree::move: box is empty"));
  EXPECT_THAT(text_of<Error>([&] { tree.remove(handle + 1); }), ::testing::HasSubstr("handle 1 holds no box"));
  EXPECT_EQ(tree.in_box({{1, 1, 1}, {2, 2, 2}}), std::vector<std::uint32_t>{handle});
  tree.remove(handle);
  EXPECT_THAT(text_of<Error>([&] { tree.remove(handle); }), ::testing::HasSubstr("remove: handle 0 holds no box"));
  EXPECT_EQ(tree.size(), 0u);
  EXPECT_THAT(text_of<InvalidShape>([] {
                (void)LooseQuadtree(Aabb2{{0, 1}, {0, 0}});
              }),
              ::testing::HasSubstr("LooseOctree: world is empty"));
}

}  // namespace
}  // namespace plumb
