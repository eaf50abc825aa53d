#include "arith/leading_digits.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "arith/samples.hpp"
#include "certify/sanitized.hpp"

namespace plumb {
namespace {

using samples::rational;

TEST(LeadingDigitsTest, HoldTheNumber) {
  int told = 0, cut = 0;
  for (std::uint64_t index = 0; index < battery::fitting<std::uint64_t>(20'000); ++index) {
    SCOPED_TRACE(index);
    Entropy entropy(7, index);
    StackDyadic::clear_range();
    StackDyadic x(1.0);
    mpq_class exact = 1;
    for (std::uint64_t step = 1 + entropy.below(6); step-- > 0;) {
      const double a = std::ldexp(wide_coordinate(entropy), static_cast<int>(entropy.within(100)));
      const double b = entropy.below(3) == 0 ? 0 : std::ldexp(wide_coordinate(entropy), -60);
      x = x * StackDyadic(a) - StackDyadic(b), exact = exact * rational(a) - rational(b);
    }
    if (StackDyadic::left_range()) continue;
    const Ball leading = arith::leading_digits(x);
    if (!(leading.radius < Ball::infinity)) continue;
    ++told, cut += x.limbs().size() > 3;
    ASSERT_LE(abs(exact - rational(leading.high) - rational(leading.low)), rational(leading.radius));
    ASSERT_LE(rational(leading.radius), abs(exact) * rational(0x1p-90));
  }
  EXPECT_GT(told, battery::fitting(10'000));
  EXPECT_GT(cut, battery::fitting(1'000));
}

TEST(LeadingDigitsTest, ZeroIsZeroAndNothingIsToldOfTheUnrepresentable) {
  const Ball zero = arith::leading_digits(StackDyadic(0.0));
  EXPECT_EQ(zero.high, 0);
  EXPECT_EQ(zero.radius, 0);
  EXPECT_EQ(arith::leading_digits(StackDyadic(-3.0)).nearest(), -3);
  EXPECT_FALSE(arith::leading_digits(StackDyadic(0x1p1000)).nearest());
  EXPECT_FALSE(arith::leading_digits(StackDyadic(0x1p-1000)).nearest());
}

}  // namespace
}  // namespace plumb
