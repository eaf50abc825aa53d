#include "plumb/arith/ball.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "arith/samples.hpp"
#include "certify/sanitized.hpp"

namespace plumb {
namespace {

using samples::rational;

testing::AssertionResult contains(const Ball& b, const mpq_class& x) {
  if (!(b.radius < Ball::infinity)) return testing::AssertionSuccess();  // claims nothing
  const mpq_class off = abs(x - rational(b.high) - rational(b.low));
  if (off <= rational(b.radius) && b.high == b.high + b.low) return testing::AssertionSuccess();
  return testing::AssertionFailure() << std::hexfloat << b.high << " + " << b.low << " +- " << b.radius << " misses "
                                     << x.get_str();
}

void check_pair(double a, double b) {
  SCOPED_TRACE(testing::Message() << std::hexfloat << a << " and " << b);
  const mpq_class qa = rational(a), qb = rational(b);
  ASSERT_TRUE(contains(Ball{a} + Ball{b}, qa + qb));
  ASSERT_TRUE(contains(Ball{a} - Ball{b}, qa - qb));
  ASSERT_TRUE(contains(Ball{a} * Ball{b}, qa * qb));
  ASSERT_TRUE(contains(difference(a, Ball{b}), qa - qb));
  ASSERT_TRUE(contains(squared(Ball{a}), qa * qa));
  if (b != 0) {
    ASSERT_TRUE(contains(quotient(Ball{a}, Ball{b}), qa / qb));
  }
}

TEST(BallTest, HoldsTheExactResultForAllPairsOfSpecialValues) {
  for (const double a : samples::special_values()) {
    for (const double b : samples::special_values()) {
      check_pair(a, b);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(BallTest, HoldsTheExactResultOfChains) {
  int finite = 0, sharp = 0, quotients = 0;
  for (std::uint64_t index = 0; index < battery::fitting<std::uint64_t>(50'000); ++index) {
    SCOPED_TRACE(index);
    Entropy entropy(1, index);
    const auto draw = [&] {
      return entropy.below(4) == 0 ? extreme_coordinate(entropy) : std::ldexp(wide_coordinate(entropy), -20);
    };
    double last = draw();
    Ball ball{last};
    mpq_class exact = rational(last);
    for (int step = 0; step < 12; ++step) {
      last = entropy.below(4) == 0 ? moved_by_ulps(-ball.high, entropy.within(3)) : draw();
      if (!(std::fabs(last) < samples::infinity)) break;
      const Ball other = Ball{last} * Ball{1 + 0x1p-30} + Ball{0x1p-70};
      const mpq_class exact_other = rational(last) * rational(1 + 0x1p-30) + rational(0x1p-70);
      switch (entropy.below(4)) {
        case 0:
          ball = ball + other, exact += exact_other;
          break;
        case 1:
          ball = other - ball, exact = exact_other - exact;
          break;
        case 2:
          ball = ball * other, exact *= exact_other;
          break;
        default:
          if (exact_other == 0) break;
          ball = quotient(ball, other), exact /= exact_other, ++quotients;
      }
      ASSERT_TRUE(contains(ball, exact));
      ASSERT_TRUE(contains(difference(last, ball), rational(last) - exact));
      const Ball square = squared(ball), product = ball * ball;
      ASSERT_TRUE(contains(square, exact * exact));
      if (product.radius < Ball::infinity) {
        ASSERT_LE(square.radius, product.radius * (1 + 0x1p-40) + 0x1p-1050);
      }
      finite += ball.radius < Ball::infinity;
      sharp += ball.radius <= std::fabs(ball.high) * 0x1p-90;
      if (!(ball.radius < Ball::infinity)) break;
    }
  }
  EXPECT_GT(quotients, battery::fitting(20'000));
  EXPECT_GT(finite, battery::fitting(100'000));
  EXPECT_GT(sharp * 10, finite * 8);
}

TEST(BallTest, NearestIsTheNearestDoubleOrNothing) {
  const double next = moved_by_ulps(1, 1);
  EXPECT_EQ(Ball(1, 0, 0).nearest(), 1);
  EXPECT_EQ(Ball(1, 0x1p-53, 0).nearest(), 1);  // a tie, known exactly: `high` is rounded to even
  EXPECT_FALSE(Ball(1, 0x1p-53, 0x1p-110).nearest());
  EXPECT_FALSE(Ball(1, 0x1p-53, 0x1p-1074).nearest());
  EXPECT_EQ(Ball(1, 0x1p-53 - 0x1p-100, 0x1p-103).nearest(), 1);
  EXPECT_FALSE(Ball(1, 0x1p-53 - 0x1p-103, 0x1p-102).nearest());
  EXPECT_EQ(Ball(next, -0x1p-53 + 0x1p-100, 0x1p-103).nearest(), next);
  EXPECT_FALSE(Ball(0, 0, 0x1p-1074).nearest());
  EXPECT_FALSE(Ball(0, 0, Ball::infinity).nearest());
  EXPECT_FALSE(std::signbit(*Ball(-0.0, 0, 0).nearest()));
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(Ball(largest, 0, 1).nearest(), largest);
  EXPECT_FALSE(Ball(largest, 0x1p969, 0x1p960).nearest() && std::isinf(*Ball(largest, 0x1p969, 0x1p960).nearest()));
  EXPECT_FALSE(Ball(largest, 0x1p970, 0x1p900).nearest());
}

TEST(BallTest, HoldsTheExactRoot) {
  int claimed = 0, sharp = 0;
  for (std::uint64_t index = 0; index < battery::fitting<std::uint64_t>(50'000); ++index) {
    SCOPED_TRACE(index);
    Entropy entropy(2, index);
    const double x = std::fabs(entropy.coin() ? wide_coordinate(entropy) : extreme_coordinate(entropy));
    const Ball radicand = Ball{x} + Ball{std::ldexp(x, -60)} * Ball{unit_coordinate(entropy)};
    const Ball r = root(radicand);
    if (!(r.radius < Ball::infinity && radicand.radius < Ball::infinity)) continue;
    ++claimed;
    const mpq_class least = rational(radicand.high) + rational(radicand.low) - rational(radicand.radius);
    const mpq_class most = rational(radicand.high) + rational(radicand.low) + rational(radicand.radius);
    const mpq_class from = rational(r.high) + rational(r.low) - rational(r.radius);
    const mpq_class to = rational(r.high) + rational(r.low) + rational(r.radius);
    ASSERT_TRUE(from <= 0 || from * from <= least);
    ASSERT_TRUE(to >= 0 && to * to >= most);
    sharp += r.radius <= r.high * 0x1p-90;
  }
  EXPECT_GT(claimed, battery::fitting(30'000));
  EXPECT_GT(sharp * 10, claimed * 9);
  EXPECT_EQ(root(Ball{49}).radius, 0);
  EXPECT_EQ(root(Ball{0}).high, 0);
}

TEST(BallTest, RoundsOutwardOrNotAtAll) {
  const double above = moved_by_ulps(1, 1), below = moved_by_ulps(1, -1);
  for (const Rounding way : {Rounding::down, Rounding::up}) {
    const bool up = way == Rounding::up;
    EXPECT_EQ(Ball(1, 0, 0).rounded(way), 1);
    EXPECT_EQ(Ball(1, 0x1p-80, 0).rounded(way), up ? above : 1);
    EXPECT_EQ(Ball(1, -0x1p-80, 0).rounded(way), up ? 1 : below);
    EXPECT_EQ(Ball(1, 0x1p-80, 0x1p-90).rounded(way), up ? above : 1);
    EXPECT_EQ(Ball(-1, 0x1p-80, 0x1p-90).rounded(way), up ? -below : -1);
    EXPECT_FALSE(Ball(1, 0x1p-80, 0x1p-79).rounded(way));
    EXPECT_FALSE(Ball(1, 0, 0x1p-1074).rounded(way));
    EXPECT_EQ(Ball(0, 0, 0).rounded(way), 0);
    EXPECT_FALSE(Ball(1, 0, Ball::infinity).rounded(way));
    EXPECT_FALSE(std::signbit(*Ball(-0.0, 0, 0).rounded(way)));
  }
}

TEST(BallTest, TellsTheSignThatAllItHoldsHave) {
  int certain = 0, unsure = 0;
  for (std::uint64_t index = 0; index < battery::fitting<std::uint64_t>(20'000); ++index) {
    SCOPED_TRACE(index);
    Entropy entropy(9, index);
    const double high = std::ldexp(wide_coordinate(entropy), -20);
    const double low = std::ldexp(high, -54) * (static_cast<double>(entropy.below(3)) - 1);
    const double radius = moved_by_ulps(std::fabs(high) / (entropy.below(2) == 0 ? 1 : 2), entropy.within(3));
    if (!(radius >= 0)) continue;
    const Ball ball{high, low, radius};
    const mpq_class middle = rational(high) + rational(low);
    const int least = sgn(middle - rational(radius)), most = sgn(middle + rational(radius));
    const Unsure<Sign> sign = ball.sign();
    if (sign.certain()) {
      ASSERT_EQ(static_cast<int>(sign.value()), least);
      ASSERT_EQ(least, most);
    }
    if (radius < std::fabs(high) / 2) {
      ASSERT_TRUE(sign.certain());
    }
    ++(sign.certain() ? certain : unsure);
  }
  EXPECT_GT(certain, battery::fitting(1000));
  EXPECT_GT(unsure, battery::fitting(1000));
  EXPECT_EQ(Ball{0.0}.sign(), Unsure{Sign::zero});
  EXPECT_FALSE((Ball{1, 0, Ball::infinity}).sign().certain());
}

TEST(BallTest, IntegersStayExact) {
  const Ball seven{7}, three{3};
  EXPECT_EQ((seven * three - three * three * three).radius, 0);
  EXPECT_EQ(quotient(seven * three, three).radius, 0);
  EXPECT_EQ(quotient(seven * three, three).high, 7);
  EXPECT_GT(quotient(seven, three).radius, 0);
  EXPECT_FALSE(quotient(seven, three - three).radius < Ball::infinity);
}

}  // namespace
}  // namespace plumb
