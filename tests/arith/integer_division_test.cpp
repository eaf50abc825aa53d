// Are quotients of integers rounded as rational ones are, and compared as they are?  All small ones, and the ends of types.
#include "plumb/arith/integer_division.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "plumb/arith/rational.hpp"
#include "plumb/degenerate.hpp"

namespace plumb {
namespace {

Rational quotient_of(std::int64_t a, std::int64_t b) { return Rational(a) / Rational(b); }

template <class Integer>
void expect_rounded(Integer a, Integer b) {
  const Rational exact = quotient_of(a, b), below = exact.floor(), above = exact.ceil();
  const std::string about = std::to_string(a) + " / " + std::to_string(b);
  EXPECT_TRUE(Rational(std::int64_t{integer_quotient(Rounding::down, a, b)}) == below) << about;
  EXPECT_TRUE(Rational(std::int64_t{integer_quotient(Rounding::up, a, b)}) == above) << about;
  const Rational nearest(std::int64_t{integer_quotient(Rounding::nearest, a, b)});
  const auto order = (exact - below) <=> (above - exact);
  const Rational half = below / Rational(2);
  const Rational wanted = order < 0 ? below : order > 0 ? above : half == half.floor() ? below : above;
  EXPECT_TRUE(nearest == wanted) << about;
}

TEST(IntegerDivision, AllQuotientsOfSmallNumbers) {
  for (int a = -128; a < 128; ++a) {
    for (int b = -128; b < 128; ++b) {
      if (b == 0 || (a == -128 && b == -1)) continue;
      if (a % 3 == 0 || a < -120 || b < -120) expect_rounded(static_cast<std::int8_t>(a), static_cast<std::int8_t>(b));
    }
  }
}

TEST(IntegerDivision, AtTheEndsOfTheType) {
  constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min(),
                         most = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t a : {least, least + 1, most, most - 1, std::int64_t{-1}, std::int64_t{0}, std::int64_t{3}}) {
    for (const std::int64_t b : {least, least + 1, most, most - 1, std::int64_t{-1}, std::int64_t{2}, least / 2}) {
      if (!(a == least && b == -1)) expect_rounded(a, b);
      for (const std::int64_t c : {least, most, std::int64_t{-2}, std::int64_t{1}}) {
        for (const std::int64_t d : {least, most, std::int64_t{-3}, std::int64_t{1}}) {
          const auto order = quotient_of(a, b) <=> quotient_of(c, d);
          EXPECT_EQ(compare_quotients(a, b, c, d), order < 0   ? Sign::negative
                                                   : order > 0 ? Sign::positive
                                                               : Sign::zero);
        }
      }
    }
  }
  EXPECT_THROW((void)integer_quotient(Rounding::down, least, std::int64_t{-1}), NoQuotient);
  EXPECT_THROW((void)integer_quotient(Rounding::up, 1, 0), NoQuotient);
  EXPECT_THROW((void)compare_quotients(1, 1, 1, 0), NoQuotient);
}

TEST(IntegerDivision, Random) {
  for (std::uint64_t index = 0; index < 500; ++index) {
    Entropy entropy(831, index);
    const auto number = [&] { return static_cast<std::int64_t>(entropy.bits(63) >> entropy.below(63)); };
    const std::int64_t a = number(), b = entropy.coin() ? -number() : number();
    if (b == 0) continue;
    expect_rounded(a, b == -1 ? 1 : b);
  }
  static_assert(integer_quotient(Rounding::down, -7, 2) == -4 && integer_quotient(Rounding::nearest, 7, 2) == 4);
}

}  // namespace
}  // namespace plumb
