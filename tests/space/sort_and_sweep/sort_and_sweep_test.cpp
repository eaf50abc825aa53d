// Does sorting and sweeping find what asking each pair finds: from scratch along any axis, and with an order that is
// kept?
#include "plumb/space/sort_and_sweep/sort_and_sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/space/pairs/brute_force_pairs.hpp"
#include "plumb/space/sort_and_sweep/sweep_array.hpp"
#include "space/pairs/box_scenes.hpp"

namespace plumb {
namespace {

using box_scenes::part;
using box_scenes::Scene;
using ::testing::HasSubstr;

constexpr int scenes = static_cast<int>(box_scenes::last_scene) + 1;

std::vector<BoxPair> ascending(std::vector<BoxPair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

template <class Box>
void expect_by_every_axis(const std::vector<Box>& boxes, bool in_space, const std::string& about) {
  for (const bool touching : {true, false}) {
    const auto expected = brute_force_pairs(boxes, {.touching = touching});
    for (const SweepAxis axis : {SweepAxis::greatest_variance, SweepAxis::x, SweepAxis::y, SweepAxis::z}) {
      if (axis == SweepAxis::z && !in_space) continue;
      ASSERT_EQ(ascending(sort_and_sweep_pairs(boxes, {touching, Execution::serial, axis})), expected) << about;
    }
    ASSERT_EQ(sort_and_sweep_pairs(boxes, {touching, Execution::serial}), sort_and_sweep_pairs(boxes, {touching}));
  }
}

TEST(SortAndSweep, FindsThePairsOfBruteForceAlongEveryAxis) {
  for (int s = 0; s < scenes; ++s) {
    for (std::uint64_t i = 0; i < battery::fitting(20u); ++i) {
      Entropy e(2061, i);
      const auto boxes = box_scenes::boxes_of(static_cast<Scene>(s), e, i < 3 ? i : 1 + e.below(150));
      const std::string about = "scene " + std::to_string(s) + ", case " + std::to_string(i);
      expect_by_every_axis(boxes, true, about);
      expect_by_every_axis(box_scenes::in_floats(boxes), true, about);
      expect_by_every_axis(box_scenes::in_the_plane(boxes), false, about);
      expect_by_every_axis(box_scenes::in_floats(box_scenes::in_the_plane(boxes)), false, about);
    }
  }
}

TEST(SortAndSweep, TakesTheAxisOfGreatestVariance) {
  std::vector<Aabb3> boxes;
  for (int i = 0; i < 9; ++i) boxes.push_back({{0.5 * i, 3.0 * i, -1e6}, {0.5 * i, 3.0 * i, 1e6}});
  EXPECT_EQ(axis_of_greatest_variance(boxes), SweepAxis::y);
  EXPECT_EQ(axis_of_greatest_variance(std::vector<Aabb2>{{{-1e300, 0}, {-1e300, 1}}, {{1e300, 0}, {1e300, 1}}}),
            SweepAxis::x);
  EXPECT_THAT(text_of<InvalidShape>([] { sort_and_sweep_pairs(std::vector<Aabb2>{}, {.axis = SweepAxis::z}); }),
              HasSubstr("options.axis is z"));
  boxes[3].min.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(text_of<NonFinite>([&] { sort_and_sweep_pairs(boxes); }), HasSubstr("boxes[3].min.x"));
}

// Frames in which all boxes tremble, and now and then some jump or change places.
TEST(SweepArray, AnswersAsFromScratchInEveryFrame) {
  std::size_t kept = 0, anew = 0, steps = 0;
  for (int s = 0; s < scenes; ++s) {
    Entropy e(2062, static_cast<std::uint64_t>(s));
    auto boxes = box_scenes::boxes_of(static_cast<Scene>(s), e, 60 + e.below(60));
    SweepArray sweep({.touching = s % 2 == 0});
    for (std::size_t frame = 0; frame < battery::fitting(200u); ++frame) {
      for (Aabb3& b : boxes) {
        if (e.below(4) != 0 || std::abs(b.max.x) > 1e6) continue;
        const double by = 0.25 * (part(e) - 0.5);
        b.min.x += by, b.max.x += by, b.min.y -= by, b.max.y -= by;
      }
      if (e.below(8) == 0) std::swap(boxes[e.below(boxes.size())], boxes[e.below(boxes.size())]);
      if (e.below(32) == 0) std::reverse(boxes.begin(), boxes.end());
      if (e.below(32) == 0 && boxes.size() > 2) boxes.pop_back();
      ASSERT_EQ(sweep.overlapping_pairs(boxes), sort_and_sweep_pairs(boxes, {s % 2 == 0, Execution::serial}))
          << "scene " << s << ", frame " << frame;
      ++(sweep.from_scratch() ? anew : kept);
      steps += sweep.steps();
    }
    EXPECT_TRUE(sweep.overlapping_pairs({}).empty());
  }
  EXPECT_GT(kept, anew);
  EXPECT_GT(anew, 20u);
  EXPECT_GT(steps, 1000u);
}

}  // namespace
}  // namespace plumb
