// Does the broad phase find what asking each pair finds, by every method, however it is asked, on every instruction set?
#include "plumb/space/broad_phase/overlapping_pairs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "certify/batch/take_instruction_set.hpp"
#include "certify/sanitized.hpp"
#include "figure/basic/thrown.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/instruction_set.hpp"
#include "plumb/space/pairs/brute_force_pairs.hpp"
#include "space/pairs/box_scenes.hpp"

namespace plumb {
namespace {

using box_scenes::Scene;
using ::testing::HasSubstr;

std::vector<BoxPair> sorted(std::vector<BoxPair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Which pairs are expected; each may be told once.
class Expected {
 public:
  Expected(const std::vector<BoxPair>& pairs, std::size_t n) : n_(n), count_(pairs.size()), told_(n * n, -1) {
    for (const BoxPair& p : pairs) told_[p.a * n_ + p.b] = 0;
  }
  bool are(const std::vector<BoxPair>& found) {
    ++turn_;
    for (const BoxPair& p : found) {
      int& told = told_[p.a * n_ + p.b];
      if (told < 0 || told == turn_) return false;
      told = turn_;
    }
    return found.size() == count_;
  }

 private:
  std::size_t n_, count_;
  int turn_ = 0;
  std::vector<int> told_;
};

struct Seen {
  std::size_t pairs = 0, without_touching = 0;
};

template <class Box>
void expect_brute_force(const std::vector<Box>& boxes, std::size_t first, const std::string& about, Seen& seen) {
  const std::span all(boxes);
  const auto a = all.first(first), b = all.subspan(first);
  for (const bool touching : {true, false}) {
    const auto expected = brute_force_pairs(all, {.touching = touching});
    const auto of_two = brute_force_pairs(a, b, {.touching = touching});
    Expected expected_one(expected, all.size()), expected_two(of_two, all.size());
    (touching ? seen.pairs : seen.without_touching) += expected.size();
    for (const BroadPhaseMethod method : broad_phase_methods) {
      const bool is_widened = !std::is_same_v<Box, Aabb2> && !std::is_same_v<Box, Aabb3>;
      if (all.size() > (is_widened ? 24 : 64) && method > BroadPhaseMethod::brute_force) continue;
      const BroadPhaseOptions options{touching, Execution::serial, method};
      ASSERT_TRUE(expected_one.are(overlapping_pairs(all, options))) << about << " by " << name_of(method);
      ASSERT_TRUE(expected_two.are(overlapping_pairs(a, b, options))) << about << " by " << name_of(method);
    }
  }
}

TEST(OverlappingPairs, AreThoseOfBruteForce) {
  for (int s = 0; s <= static_cast<int>(box_scenes::last_scene); ++s) {
    Seen seen;
    for (std::uint64_t i = 0; i < (battery::sanitized ? 6u : 17u); ++i) {
      Entropy e(2041, i);
      const std::size_t n = i < 4 ? i : e.below(i % 8 == 0 ? 400 : 120) + 1;
      const auto boxes = box_scenes::boxes_of(static_cast<Scene>(s), e, n);
      const std::string about = "scene " + std::to_string(s) + ", case " + std::to_string(i);
      const std::size_t first = e.below(n + 1);
      expect_brute_force(boxes, first, about + " in space", seen);
      expect_brute_force(box_scenes::in_floats(boxes), first, about + " in floats", seen);
      const auto plane = box_scenes::in_the_plane(boxes);
      expect_brute_force(plane, first, about + " in the plane", seen);
      expect_brute_force(box_scenes::in_floats(plane), first, about + " in floats in the plane", seen);
    }
    if (!battery::reaches_rare) continue;
    EXPECT_GT(seen.pairs, 100u) << s;
    const Scene scene = static_cast<Scene>(s);
    if (scene == Scene::lattice || scene == Scene::flat || scene == Scene::off_lattice) {
      EXPECT_LT(seen.without_touching, seen.pairs) << s;
      EXPECT_GT(seen.without_touching, 0u) << s;
    }
  }
}

// Enough for several columns, blocks and threads.
TEST(OverlappingPairs, AreTheSameOnAllThreadsAndInstructionSets) {
  struct Case {
    Scene scene;
    BroadPhaseMethod method;
    std::size_t n;
  };
  constexpr auto columns = BroadPhaseMethod::swept_columns, along_one = BroadPhaseMethod::sort_and_sweep;
  for (const auto& [scene, method, most] :
       {Case{Scene::uniform, columns, 40000}, Case{Scene::sizes, columns, 8000},
        Case{Scene::off_lattice, columns, 8000}, Case{Scene::one_far, columns, 8000},
        Case{Scene::clustered, columns, 2000}, Case{Scene::on_a_line, columns, 20000},
        Case{Scene::uniform, along_one, 8000}, Case{Scene::off_lattice, along_one, 3000}}) {
    const std::size_t n = battery::fitting(most);
    Entropy e(2042, static_cast<std::uint64_t>(scene));
    const auto boxes = box_scenes::boxes_of(scene, e, n);
    const std::span all(boxes);
    const auto ask = [&, of = method](Execution execution) {
      const BroadPhaseOptions options{.execution = execution, .method = of};
      return std::pair(overlapping_pairs(all, options),
                       overlapping_pairs(all.first(n / 3), all.subspan(n / 3), options));
    };
    certify::batch::take_instruction_set(batch_instruction_sets().front());
    const auto first = ask(Execution::serial);
    if (battery::reaches_rare) {
      EXPECT_GT(first.first.size(), n / 4);
      EXPECT_GT(first.second.size(), n / 16);
    }
    for (const std::string_view set : batch_instruction_sets()) {
      certify::batch::take_instruction_set(set);
      EXPECT_TRUE(ask(Execution::parallel) == first) << static_cast<int>(scene) << " by " << set;
    }
    certify::batch::take_instruction_set({});
    const auto pairs = sorted(first.first);
    EXPECT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end());
    const auto other = method == columns ? along_one : columns;
    EXPECT_TRUE(sorted(overlapping_pairs(boxes, BroadPhaseOptions{.method = other})) == pairs);
    if (n <= 8000) {
      EXPECT_TRUE(brute_force_pairs(all) == pairs) << static_cast<int>(scene);
    }
  }
}

// Of two sets as of one, and whatever order these find them in.
TEST(OverlappingPairs, AreTheSameOnAllThreadsByEveryMethod) {
  const std::size_t n = battery::fitting(500u);
  for (const Scene scene : {Scene::uniform, Scene::sizes}) {
    Entropy e(2044, static_cast<std::uint64_t>(scene));
    const auto boxes = box_scenes::boxes_of(scene, e, n);
    const std::span all(boxes);
    const auto expected = brute_force_pairs(all);
    for (const BroadPhaseMethod method : broad_phase_methods) {
      BroadPhaseOptions options{.execution = Execution::serial, .method = method};
      const auto one = overlapping_pairs(all, options);
      const auto two = overlapping_pairs(all.first(n / 3), all.subspan(n / 3), options);
      options.execution = Execution::parallel;
      EXPECT_TRUE(overlapping_pairs(all, options) == one) << name_of(method);
      EXPECT_TRUE(overlapping_pairs(all.first(n / 3), all.subspan(n / 3), options) == two) << name_of(method);
      EXPECT_TRUE(Expected(expected, n).are(one)) << name_of(method);
    }
    if (battery::reaches_rare) {
      EXPECT_GT(expected.size(), n / 4);
    }
  }
}

TEST(OverlappingPairs, AreFoundByMethodsWithNamesOfTheirOwn) {
  for (std::size_t i = 0; i < broad_phase_methods.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(broad_phase_methods[i]), i);
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(name_of(broad_phase_methods[i]), name_of(broad_phase_methods[j]));
  }
  const std::vector<Aabb3> boxes(3, Aabb3{{0, 0, 0}, {1, 1, 1}});
  const auto unnamed = static_cast<BroadPhaseMethod>(broad_phase_methods.size());
  EXPECT_THAT(text_of<InvalidShape>([&] { overlapping_pairs(boxes, BroadPhaseOptions{.method = unnamed}); }),
              HasSubstr("options.method is 18, which names none"));
}

TEST(OverlappingPairs, GoToEverySink) {
  Entropy e(2043);
  const auto boxes = box_scenes::boxes_of(Scene::uniform, e, 3000);
  const auto expected = overlapping_pairs(boxes);
  ASSERT_GT(expected.size(), 2000u);
  std::vector<BoxPair> appended{{7, 9}}, called;
  overlapping_pairs(boxes, BoxPairSink(appended));
  EXPECT_EQ(appended.front(), (BoxPair{7, 9}));
  appended.erase(appended.begin());
  EXPECT_EQ(appended, expected);
  auto call = [&](std::span<const BoxPair> block) { called.insert(called.end(), block.begin(), block.end()); };
  overlapping_pairs(boxes, BoxPairSink(call));
  EXPECT_EQ(called, expected);

  std::vector<BoxPair> memory(expected.size());
  PairsInSpan fits(memory), too_few(std::span<BoxPair>(memory).first(1000));
  overlapping_pairs(boxes, BoxPairSink(fits));
  EXPECT_TRUE(fits.all_fit());
  EXPECT_EQ(memory, expected);
  overlapping_pairs(boxes, BoxPairSink(too_few));
  EXPECT_FALSE(too_few.all_fit());
  EXPECT_EQ(too_few.count(), expected.size());
  EXPECT_TRUE(std::equal(too_few.overlapping_pairs().begin(), too_few.overlapping_pairs().end(), expected.begin(),
                         expected.begin() + 1000));
}

TEST(OverlappingPairs, RefuseBadBoxesByName) {
  std::vector<Aabb3> boxes(60, Aabb3{{0, 0, 0}, {1, 1, 1}});
  boxes[17].max.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(text_of<NonFinite>([&] { overlapping_pairs(boxes); }), HasSubstr("overlapping_pairs: boxes[17].max.y"));
  boxes[17].max.y = -std::numeric_limits<double>::infinity();
  EXPECT_THAT(text_of<NonFinite>([&] { brute_force_pairs(boxes); }), HasSubstr("brute_force_pairs: boxes[17].max.y"));
  boxes[17].max.y = -1;
  EXPECT_THAT(text_of<InvalidShape>([&] { overlapping_pairs(boxes); }),
              HasSubstr("overlapping_pairs: boxes[17] is empty, its min.y is above its max.y"));
  const std::vector<Aabb3> good(2, Aabb3{{0, 0, 0}, {1, 1, 1}});
  EXPECT_THAT(text_of<InvalidShape>([&] { overlapping_pairs(good, boxes); }), HasSubstr("b[17] is empty"));
  EXPECT_THAT(text_of<InvalidShape>([&] { overlapping_pairs(boxes, good); }), HasSubstr("a[17] is empty"));
  const std::vector<FloatBox2> flat{{{1, 1}, {0, 2}}};
  EXPECT_THAT(text_of<InvalidShape>([&] { overlapping_pairs(flat); }), HasSubstr("boxes[0] is empty, its min.x"));
}

TEST(OverlappingPairs, OfNothingAreNone) {
  const std::vector<Aabb3> none, one{{{0, 0, 0}, {1, 1, 1}}};
  EXPECT_TRUE(overlapping_pairs(none).empty());
  EXPECT_TRUE(overlapping_pairs(one).empty());
  EXPECT_TRUE(overlapping_pairs(none, one).empty());
  EXPECT_EQ(overlapping_pairs(one, one), (std::vector<BoxPair>{{0, 0}}));
}

}  // namespace
}  // namespace plumb
