#include "arith/infinitesimal.hpp"

#include <gtest/gtest.h>

#include "plumb/arith/big.hpp"
#include "plumb/degenerate/entropy.hpp"

namespace plumb {
namespace {

using Number = Infinitesimal<BigRational>;

Number real(double x) { return Number(big_rational(x)); }
Number e(std::size_t number) { return Number::moved(big_rational(0), big_rational(1), number); }

TEST(InfinitesimalTest, IsPositiveAndBelowEveryPositiveNumber) {
  EXPECT_EQ(e(0).sign(), Sign::positive);
  EXPECT_EQ((e(0) - real(0x1p-1074)).sign(), Sign::negative);
  EXPECT_EQ((real(0x1p1023) * e(0) - real(0x1p-1074)).sign(), Sign::negative);
  EXPECT_EQ(real(0).sign(), Sign::zero);
}

TEST(InfinitesimalTest, EachIsBelowEveryPowerOfThoseBefore) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = i + 1; k < 5; ++k) {
      const Number square = e(i) * e(i), power = square * square * square;
      EXPECT_EQ((power - real(0x1p1000) * e(k)).sign(), Sign::positive) << i << " " << k;
    }
  }
  EXPECT_EQ((e(1) * e(0) - e(1) * e(1)).sign(), Sign::positive);
  EXPECT_EQ((e(1) * e(0) * e(0) - e(1)).sign(), Sign::negative);
  EXPECT_EQ((e(2) - e(2) * e(0)).sign(), Sign::positive);
}

TEST(InfinitesimalTest, TermsThatCancelAreGone) {
  const Number a = Number::moved(big_rational(3), big_rational(1), 2);
  EXPECT_EQ((a - a).sign(), Sign::zero);
  EXPECT_TRUE((a - a).terms().empty());
  EXPECT_EQ(((a + e(0)) * (a - e(0)) - (a * a - e(0) * e(0))).sign(), Sign::zero);
  EXPECT_EQ((a * a).terms().size(), 3u);
}

// Numbers small enough to stand for the infinitesimals of an expression tell the same sign.
TEST(InfinitesimalTest, IsWhatSmallEnoughNumbersTell) {
  for (std::uint64_t number = 0; number < 2'000; ++number) {
    Entropy entropy(2, number);
    const auto expression = [number](const auto& moved) {
      Entropy choices(1, number);
      auto sum = moved(choices);
      for (int i = 0; i < 3; ++i) {
        auto product = moved(choices);
        for (int k = 0; k < 2; ++k) product = product * moved(choices);
        sum = choices.coin() ? sum + product : sum - product;
      }
      return sum;
    };
    const auto place = [](Entropy& c) { return std::pair{static_cast<double>(c.within(2)), c.below(4)}; };
    const Number symbolic = expression([&](Entropy& c) {
      const auto [x, j] = place(c);
      return Number::moved(big_rational(x), big_rational(1), j);
    });
    // Powers up to 3 of each: 2^-40, and the fourth power of what was before.
    const BigRational numeric = expression([&](Entropy& c) {
      const auto [x, j] = place(c);
      mpq_class small = 1;
      mpq_div_2exp(small.get_mpq_t(), small.get_mpq_t(), 40ul << (2 * j));
      return BigRational{mpq_class(mpq_class(x) + small)};
    });
    ASSERT_EQ(symbolic.sign(), numeric.sign()) << number;
  }
}

}  // namespace
}  // namespace plumb
