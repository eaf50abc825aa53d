// Which decisions are asked: ascending, none twice, spread over all, and not in step with any pattern of their order.
#include "tool/mesh/decision_sample.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace plumb::tool {
namespace {

TEST(DecisionSample, IsAllWhereNoMoreAreThere) {
  for (const std::uint64_t all : std::initializer_list<std::uint64_t>{0, 1, 17, 1000}) {
    const DecisionSample sample(all, 1000);
    ASSERT_EQ(sample.size(), all);
    for (std::uint64_t i = 0; i < all; ++i) EXPECT_EQ(sample.number(i), i);
  }
}

TEST(DecisionSample, AscendsAndTakesOneOfEachStretch) {
  constexpr std::uint64_t most = 1000;
  for (const std::uint64_t all : {1001ULL, 1999ULL, 16'000ULL, 1'234'567ULL, 1ULL << 37}) {
    const DecisionSample sample(all, most);
    ASSERT_EQ(sample.size(), most);
    std::uint64_t next = 0;
    for (std::uint64_t i = 0; i < most; ++i) {
      const std::uint64_t number = sample.number(i);
      EXPECT_GE(number, next);
      EXPECT_LT(number, all);
      EXPECT_LE(number / (all / most + 1), i);  // within its stretch, whatever the remainder
      EXPECT_EQ(number, DecisionSample(all, most).number(i));
      next = number + 1;
    }
  }
}

TEST(DecisionSample, IsNotInStepWithAPattern) {
  // Sixteen decisions a face: a stride of 32 would ask of two points alone.
  const DecisionSample sample(16 * 20'000, 10'000);
  std::array<int, 16> asked{};
  for (std::uint64_t i = 0; i < sample.size(); ++i) ++asked[sample.number(i) % 16];
  for (const int n : asked) EXPECT_NEAR(n, 625, 150);  // six deviations
}

}  // namespace
}  // namespace plumb::tool
