// Does choose_index count what is there, name every method, and measure where it is asked to?
#include "plumb/space/broad_phase/choose_index.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "space/pairs/box_scenes.hpp"

namespace plumb {
namespace {

using box_scenes::Scene;
using ::testing::HasSubstr;

std::vector<Aabb3> boxes_of(Scene scene, std::size_t n) {
  Entropy e(2061, static_cast<std::uint64_t>(scene));
  return box_scenes::boxes_of(scene, e, n);
}

const IndexCost& cost_of_method(const IndexChoice& choice, BroadPhaseMethod method, bool is_kept = false) {
  for (const IndexCost& cost : choice.costs) {
    if (cost.method == method && cost.is_kept == is_kept) return cost;
  }
  throw InvalidShape("no such method");
}

TEST(ChooseIndex, NamesEveryMethodOnceInTheOrderOfItsPrediction) {
  for (int s = 0; s <= static_cast<int>(box_scenes::last_scene); ++s) {
    const auto boxes = boxes_of(static_cast<Scene>(s), 300);
    for (const double share : {0.0, 0.25}) {
      for (const IndexChoice& choice : {choose_index(boxes, {.moving_share = share}),
                                        choose_index(box_scenes::in_the_plane(boxes), {.moving_share = share})}) {
        std::set<std::pair<BroadPhaseMethod, bool>> seen;
        double before = 0;
        for (const IndexCost& cost : choice.costs) {
          EXPECT_TRUE(seen.insert({cost.method, cost.is_kept}).second) << name_of(cost.method);
          EXPECT_GE(cost.predicted, before) << s;
          EXPECT_FALSE(cost.measured);
          before = cost.predicted;
        }
        EXPECT_GT(choice.best().predicted, 0) << s;
        EXPECT_LT(before, 1e9) << s;
        const std::size_t kept = choice.traits.dimensions == 3 && share > 0 ? 2 : 0, of_the_textbook = 6;
        EXPECT_EQ(seen.size(), broad_phase_methods.size() - 1 - of_the_textbook + kept) << s;
        EXPECT_EQ(seen.count({BroadPhaseMethod::automatic, false}), 0u);
        EXPECT_FALSE(choice.fastest());
        EXPECT_EQ(choice.traits.count, 300u);
        EXPECT_EQ(choice.traits.moving_share, share);
      }
    }
  }
}

TEST(ChooseIndex, TellsScenesApart) {
  const std::size_t n = battery::fitting(4000u);
  const auto even = boxes_of(Scene::uniform, n), crowded = boxes_of(Scene::clustered, n),
             sizes = boxes_of(Scene::sizes, n);
  const BoxTraits of_even = choose_index(even).traits, of_crowded = choose_index(crowded).traits,
                  of_sizes = choose_index(sizes).traits;
  EXPECT_NEAR(of_even.clustering, 1, 0.5);
  EXPECT_GT(of_crowded.clustering, 5);
  EXPECT_GT(of_sizes.size_ratio, 30);
  EXPECT_LT(of_even.size_ratio, 10);
  EXPECT_EQ(choose_index(boxes_of(Scene::equal, 200)).traits.size_ratio, 1);
  for (const auto& [boxes, traits] :
       {std::pair(crowded, of_crowded), std::pair(boxes_of(Scene::flat, n), BoxTraits{})}) {
    const double told = (traits.count != 0 ? traits : choose_index(boxes).traits).pairs;
    const double there = static_cast<double>(overlapping_pairs(boxes).size()) / static_cast<double>(n);
    EXPECT_GT(told, 0.6 * there);
    EXPECT_LT(told, 1.6 * there);
  }
}

// What anybody would say beforehand.
TEST(ChooseIndex, PredictsWhatIsWorse) {
  const auto many = boxes_of(Scene::uniform, battery::fitting(20000u)), few = boxes_of(Scene::uniform, 12);
  using Method = BroadPhaseMethod;
  const IndexChoice once = choose_index(many), of_few = choose_index(few);
  EXPECT_LT(cost_of_method(of_few, Method::brute_force).predicted, cost_of_method(of_few, Method::box_tree).predicted);
  if (!battery::reaches_rare) return;
  for (const Method slower : {Method::brute_force, Method::sort_and_sweep, Method::lists_along_three, Method::octree}) {
    EXPECT_LT(cost_of_method(once, Method::swept_columns).predicted, cost_of_method(once, slower).predicted)
        << name_of(slower);
  }
  const IndexChoice few_move = choose_index(many, {.moving_share = 0.01}),
                    all = choose_index(many, {.moving_share = 1});
  EXPECT_TRUE(few_move.best().is_kept);
  EXPECT_EQ(few_move.best().method, Method::swept_columns);
  EXPECT_LT(few_move.best().predicted, 0.5 * cost_of_method(few_move, Method::swept_columns).predicted);
  EXPECT_GT(cost_of_method(all, Method::swept_columns, true).predicted, 4 * few_move.best().predicted);
}

TEST(ChooseIndex, MeasuresEachThatIsNotPredictedToTakeTooLong) {
  const auto boxes = boxes_of(Scene::sizes, 120);
  const auto flat = box_scenes::in_the_plane(boxes);
  for (const IndexChoice& choice : {choose_index(boxes, {.moving_share = 0.5, .measure = true}),
                                    choose_index(flat, {.moving_share = 0.5, .measure = true})}) {
    ASSERT_TRUE(choice.fastest());
    for (const IndexCost& cost : choice.costs) {
      ASSERT_TRUE(cost.measured) << name_of(cost.method);
      EXPECT_GT(*cost.measured, 0) << name_of(cost.method);
      EXPECT_LE(*choice.fastest()->measured, *cost.measured);
    }
  }
  const IndexChoice none = choose_index(boxes, {.measure = true, .most_milliseconds = 0});
  EXPECT_FALSE(none.fastest());
}

TEST(ChooseIndex, RefusesWhatIsNoBoxAndNoShare) {
  std::vector<Aabb3> boxes(3, Aabb3{{0, 0, 0}, {1, 1, 1}});
  EXPECT_THAT(text_of<InvalidShape>([&] { choose_index(boxes, {.moving_share = 2}); }),
              HasSubstr("choose_index: options.moving_share is 2.0"));
  boxes[1].max.y = -1;
  EXPECT_THAT(text_of<InvalidShape>([&] { choose_index(boxes); }), HasSubstr("choose_index: boxes[1] is empty"));
  boxes[1].max.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(text_of<NonFinite>([&] { choose_index(boxes); }), HasSubstr("choose_index: boxes[1].max.y"));
  const IndexChoice of_none = choose_index(std::span<const Aabb3>(), {.measure = true});
  EXPECT_EQ(of_none.traits.count, 0u);
  EXPECT_FALSE(of_none.fastest());
}

}  // namespace
}  // namespace plumb
