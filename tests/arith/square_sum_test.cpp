// Are sums of squares and lengths as near to the exact ones as their types say, and their signs those of the exact ones?
#include "plumb/arith/square_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "arith/samples.hpp"
#include "certify/sanitized.hpp"

namespace plumb {
namespace {

using samples::rational;

const std::uint64_t cases = battery::fitting<std::uint64_t>(4000);

mpq_class square(double a, double b, double power) {
  const mpq_class d = (rational(a) - rational(b)) * rational(power);
  return d * d;
}

// Both bounds, for the exact square of a number or for itself.
template <class Computed>
void expect_near(const Computed& c, const mpq_class& exact, std::uint64_t i) {
  ASSERT_LE(rational(c.lower()), exact) << "431 " << i;
  const mpq_class off = abs(rational(c.value) - exact);
  ASSERT_LE(off, rational(Computed::relative) * rational(c.value) + rational(Computed::absolute)) << "431 " << i;
  // Whose value is this is no more than the limit: the largest such limit is below, and the least one above.
  const double limit = c.value + c.value * 0x1p-40;
  if (Computed::certainly_within(limit) >= c.value) {
    ASSERT_GE(rational(limit), exact) << "431 " << i;
  } else {
    ASSERT_LE(c.value, 0x1p-450) << "431 " << i;
  }
}

TEST(SquareSumTest, NumbersAreAsNearAsTheirTypesSay) {
  using namespace arith::squares;
  std::size_t underflows = 0, scalings = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    Entropy entropy(431, i);
    const double of = std::ldexp(1.0, static_cast<int>(entropy.within(520)));
    std::array<double, 7> x{};
    for (double& c : x)
      c = entropy.below(3) == 0 ? samples::any_double(entropy, x[0]) : of * signed_unit_coordinate(entropy);
    const double power = entropy.below(2) == 0 ? 1 : std::ldexp(1.0, static_cast<int>(entropy.within(1000)));
    scalings += power != 1 ? 1 : 0;
    const auto sum = squared(scaled(difference(x[0], x[1]), power)) + squared(scaled(difference(x[2], x[3]), power)) +
                     squared(scaled(difference(x[4], x[5]), power));
    if (!(sum.value < samples::infinity)) continue;
    const mpq_class exact = square(x[0], x[1], power) + square(x[2], x[3], power) + square(x[4], x[5], power);
    expect_near(sum, exact, i);
    underflows += sum.value < 0x1p-1022 && exact != 0 ? 1 : 0;
    // |length - root| <= reach, by squares.
    const auto length = root(sum);
    const double reach = Interval::sum_up(Interval::product_up(length.relative, length.value), length.absolute);
    const mpq_class least = rational(length.value) - rational(reach), most = rational(length.value) + rational(reach);
    ASSERT_TRUE(least <= 0 || least * least <= exact) << "431 " << i;
    ASSERT_GE(most * most, exact) << "431 " << i;
    const auto far = plus_given(length, std::fabs(x[6]));
    if (!(far.value < samples::infinity)) continue;
    const mpq_class rest = rational(far.lower()) - rational(std::fabs(x[6]));
    ASSERT_TRUE(rest <= 0 || rest * rest <= exact) << "431 " << i;
  }
  EXPECT_GE(underflows, cases / 800);
  EXPECT_GE(scalings, cases / 3);
}

// One square against another that is nearly it, or against a number: what is certainly beyond is so, and not much of
// what is beyond is doubted.
TEST(SquareSumTest, WhatIsCertainlyBeyondIs) {
  using namespace arith::squares;
  std::size_t beyond = 0, doubted = 0, infinite = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    Entropy entropy(433, i);
    const double of = std::ldexp(1.0, static_cast<int>(entropy.within(515)));
    const double x = of * signed_unit_coordinate(entropy), y = of * signed_unit_coordinate(entropy);
    const double z = moved_by_ulps(x, entropy.within(12)), w = entropy.below(4) == 0 ? 0x1p520 : y;
    const auto a = squared(difference(x, 0)) + squared(difference(y, 0)),
               b = squared(difference(z, 0)) + squared(difference(w, 0));
    if (!(a.value < samples::infinity)) continue;
    const mpq_class exact_a = square(x, 0, 1) + square(y, 0, 1), exact_b = square(z, 0, 1) + square(w, 0, 1);
    if (b.value > a.beyond()) {
      ASSERT_GT(exact_b, exact_a) << "433 " << i;
      ++beyond, infinite += b.value == samples::infinity ? 1 : 0;
    } else if (a.value > 0x1p-900) {
      ASSERT_LE(exact_b, exact_a * rational(1 + 0x1p-48)) << "433 " << i;
      doubted += exact_b > exact_a ? 1 : 0;
    }
    if (b.value > decltype(b)::certainly_beyond(a.value)) {
      ASSERT_GT(exact_b, rational(a.value)) << "433 " << i;
    } else if (a.value > 0x1p-900) {
      ASSERT_LE(exact_b, rational(a.value) * rational(1 + 0x1p-48)) << "433 " << i;
    }
  }
  EXPECT_GE(beyond, cases / 5);
  EXPECT_GE(doubted, cases / 20);
  EXPECT_GE(infinite, cases / 20);
}

// Balls that touch up to ulps, of all sizes.
TEST(SquareSumTest, ComparisonsAreThoseOfExactNumbers) {
  using namespace arith::squares;
  std::size_t sure = 0, unsure = 0, outside = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    Entropy entropy(432, i);
    const double of = std::ldexp(1.0, static_cast<int>(entropy.within(530)));
    const double x = of * signed_unit_coordinate(entropy), y = of * signed_unit_coordinate(entropy);
    const double radius = entropy.below(3) == 0 ? of * unit_coordinate(entropy) : std::hypot(x, y) / 2;
    const double other = moved_by_ulps(radius, entropy.within(3));
    const auto [value, is_sure] =
        compare(squared(difference(x, 0)) + squared(difference(y, 0)), squared(arith::squares::sum(radius, other)));
    const mpq_class reach = rational(radius) + rational(other),
                    exact = square(x, 0, 1) + square(y, 0, 1) - reach * reach;
    if (is_sure) {
      ASSERT_EQ(sign_of_number(value), sign_of_number(sgn(exact))) << "432 " << i;
    }
    sure += is_sure ? 1 : 0;
    unsure += is_sure ? 0 : 1;
    outside += is_sure && value > 0 ? 1 : 0;
  }
  EXPECT_GE(sure, cases / 5);
  EXPECT_GE(unsure, cases / 5);
  EXPECT_GE(outside, cases / 20);
}

}  // namespace
}  // namespace plumb
