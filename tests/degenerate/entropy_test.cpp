// Laws 1 to 3 of degenerate/entropy.hpp.
#include "plumb/degenerate/entropy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace {

using plumb::Entropy;

TEST(Entropy, GeneratorGivesTheSameChoicesEverywhere) {
  Entropy entropy(1, 2);
  const std::array<std::uint64_t, 4> seen = {entropy.bits(64), entropy.below(1000), entropy.bits(53), entropy.bits(1)};
  EXPECT_EQ(seen, (std::array<std::uint64_t, 4>{11460287206104075211u, 833, 2185233377743866, 0}));
}

TEST(Entropy, CasesDiffer) {
  std::vector<std::uint64_t> first;
  for (std::uint64_t start = 0; start < 40; ++start) {
    for (std::uint64_t index = 0; index < 40; ++index) first.push_back(Entropy(start, index).bits(64));
  }
  std::sort(first.begin(), first.end());
  EXPECT_EQ(std::unique(first.begin(), first.end()), first.end());
}

TEST(Entropy, BelowIsUniform) {
  Entropy entropy(3);
  std::array<int, 10> count{};
  constexpr int draws = 100'000;
  for (int i = 0; i < draws; ++i) ++count[entropy.below(10)];
  for (const int n : count) EXPECT_NEAR(n, draws / 10, 5 * std::sqrt(draws * 0.09));  // five standard deviations
}

TEST(Entropy, WithinIsSymmetricAndSimplestFirst) {
  const std::array<std::uint64_t, 5> choices = {0, 1, 2, 3, 4};
  Entropy entropy = Entropy::from_choices(choices);
  for (const std::int64_t expected : {0, 1, -1, 2, -2}) EXPECT_EQ(entropy.within(7), expected);
  Entropy random(4);
  int ends = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::int64_t x = random.within(3);
    ASSERT_LE(std::abs(x), 3);
    ends += std::abs(x) == 3;
  }
  EXPECT_GT(ends, 150);
}

TEST(Entropy, BytesAreReadAsFewAsNeeded) {
  const std::array<std::uint8_t, 5> bytes = {7, 1, 2, 255, 3};
  Entropy entropy = Entropy::from_bytes(bytes);
  EXPECT_EQ(entropy.below(1), 0u);  // no choice, no byte
  EXPECT_EQ(entropy.below(256), 7u);
  EXPECT_EQ(entropy.bits(9), 0x201u % 512);
  EXPECT_EQ(entropy.below(10), 5u);
  EXPECT_FALSE(entropy.exhausted());
  EXPECT_EQ(entropy.bits(64), 3u);
  EXPECT_TRUE(entropy.exhausted());
  EXPECT_EQ(entropy.bits(64), 0u);
}

TEST(Entropy, ReplayingTheRecordGivesTheSameChoices) {
  const auto draw = [](Entropy& entropy) {
    std::vector<std::uint64_t> seen;
    for (std::uint64_t n = 1; n < 60; ++n) {
      seen.push_back(entropy.below(n));
      seen.push_back(entropy.bits(static_cast<int>(n)));
      seen.push_back(static_cast<std::uint64_t>(entropy.within(static_cast<std::int64_t>(n))));
      seen.push_back(entropy.coin());
    }
    return seen;
  };
  std::vector<std::uint8_t> bytes(700);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * 37 + i / 5);
  for (Entropy entropy : {Entropy(9), Entropy::from_bytes(bytes)}) {
    std::vector<std::uint64_t> record, record_again;
    entropy.record_into(&record);
    const auto seen = draw(entropy);
    Entropy replay = Entropy::from_choices(record);
    replay.record_into(&record_again);
    EXPECT_EQ(draw(replay), seen);
    EXPECT_EQ(record_again, record);
  }
}

TEST(Entropy, ReducesChoicesThatDoNotFitAndAnswersZeroAfterTheEnd) {
  const std::array<std::uint64_t, 2> choices = {17, 12};
  Entropy entropy = Entropy::from_choices(choices);
  EXPECT_EQ(entropy.below(12), 5u);
  EXPECT_EQ(entropy.below(13), 12u);
  EXPECT_TRUE(entropy.exhausted());
  EXPECT_EQ(entropy.below(13), 0u);
}

}  // namespace
