// Laws 1 to 4 of shrink_choices: known least cases are found, in a bounded number of calls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "plumb/degenerate/entropy.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/degenerate/shrink.hpp"

namespace {

using Choices = std::vector<std::uint64_t>;
using View = std::span<const std::uint64_t>;

Choices random_choices(std::size_t count, std::uint64_t index) {
  plumb::Entropy entropy(21, index);
  Choices made(count);
  for (std::uint64_t& choice : made) choice = entropy.bits(static_cast<int>(entropy.below(65)));
  return made;
}

TEST(ShrinkChoices, FindsTheLeastOfOneChoice) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    Choices choices = random_choices(30, i);
    choices[17] = ~0ull;
    const auto fails = [](View c) {
      return std::any_of(c.begin(), c.end(), [](std::uint64_t x) { return x >= 12345; });
    };
    EXPECT_EQ(plumb::shrink_choices(choices, fails), Choices{12345});
  }
}

TEST(ShrinkChoices, KeepsThePlaceOfWhatMatters) {
  Choices choices = random_choices(40, 1);
  choices[5] = 99;
  choices[20] = 77;
  const auto fails = [](View c) { return c.size() >= 6 && c[5] > 10 && c.back() % 2 == 1; };
  if (choices.back() % 2 == 0) ++choices.back();
  EXPECT_EQ(plumb::shrink_choices(choices, fails), (Choices{0, 0, 0, 0, 0, 11}));
}

TEST(ShrinkChoices, SumIsReachedByTheFewestChoices) {
  const Choices choices(50, 7);
  const auto fails = [](View c) { return std::accumulate(c.begin(), c.end(), std::uint64_t{0}) >= 20; };
  const Choices least = plumb::shrink_choices(choices, fails);
  EXPECT_EQ(least, (Choices{6, 7, 7}));
}

TEST(ShrinkChoices, NothingAtAllMayFail) {
  EXPECT_EQ(plumb::shrink_choices(random_choices(20, 2), [](View) { return true; }), Choices{});
  EXPECT_EQ(plumb::shrink_choices({}, [](View) { return true; }), Choices{});
}

TEST(ShrinkChoices, CallsAreBoundedAndTheResultStillFails) {
  for (const std::size_t most : {0u, 1u, 10u, 100u}) {
    std::size_t calls = 0;
    const auto fails = [&](View c) {
      ++calls;
      return c.size() >= 3 && c[2] > 1000;
    };
    Choices choices = random_choices(200, 3);
    choices[2] = ~0ull;
    const Choices least = plumb::shrink_choices(choices, fails, most);
    EXPECT_LE(calls, most);
    EXPECT_TRUE(fails(least));
  }
}

TEST(ShrinkChoices, IsDeterministic) {
  const auto fails = [](View c) { return c.size() % 3 == 1 && c[0] % 8 == 3; };
  Choices choices = random_choices(31, 4);
  choices[0] = 7'000'003;
  EXPECT_EQ(plumb::shrink_choices(choices, fails), plumb::shrink_choices(choices, fails));
  EXPECT_EQ(plumb::shrink_choices(choices, fails), Choices{3});
}

// A failing case of points, of whatever family, becomes a small one.
TEST(ShrinkChoices, ShrinksPoints) {
  const auto make = [](View choices) {
    plumb::Entropy entropy = plumb::Entropy::from_choices(choices);
    const plumb::Family family = plumb::any_family(entropy);
    return plumb::points3(family, plumb::Degeneracy::cospherical, 5, entropy);
  };
  const auto fails = [&](View choices) {
    const auto p = make(choices);
    return p[0].x != p[1].x && p[1].y > p[2].y && p[4].z < -2;
  };
  int found = 0, small = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    plumb::Entropy entropy(22, i);
    Choices record;
    entropy.record_into(&record);
    const plumb::Family family = plumb::any_family(entropy);
    plumb::points3(family, plumb::Degeneracy::cospherical, 5, entropy);
    if (!fails(record)) continue;
    ++found;
    const auto p = make(plumb::shrink_choices(record, fails));
    double sum = 0;
    for (const auto& q : p) sum += std::abs(q.x) + std::abs(q.y) + std::abs(q.z);
    small += sum <= 25;  // integers of one digit, many of them zero
  }
  EXPECT_GT(found, 20);
  EXPECT_GE(10 * small, 8 * found);
}

}  // namespace
