// Do the bounds of roots and of pi hold what they bound, and are they as near as they say?  In rationals.
#include "arith/root_bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "plumb/degenerate/coordinates.hpp"

namespace plumb {
namespace {

mpq_class power_of_two(long exponent) {
  mpz_class power = 1;
  power <<= static_cast<mp_bitcnt_t>(std::labs(exponent));
  return exponent < 0 ? mpq_class(1, power) : mpq_class(power);
}
mpq_class rational(const BigDyadic& x) { return mpq_class(x.mantissa()) * power_of_two(x.exponent()); }

void expect_around_root(const BigDyadic& x) {
  const auto [lower, upper] = root_bounds(x);
  const mpq_class exact = rational(x), least = rational(lower), most = rational(upper);
  EXPECT_TRUE(least >= 0 && least * least <= exact) << exact;
  EXPECT_TRUE(most * most >= exact) << exact;
  EXPECT_LE(most - least, most * power_of_two(-98)) << exact;
}

TEST(RootBounds, HoldTheRoot) {
  for (std::uint64_t i = 0; i < 400; ++i) {
    Entropy entropy(77, i);
    const double a = std::fabs(i % 2 == 0 ? wide_coordinate(entropy) : extreme_coordinate(entropy)),
                 b = std::fabs(wide_coordinate(entropy));
    for (const BigDyadic& x : {BigDyadic(a), BigDyadic(a) + BigDyadic(b), BigDyadic(a) * BigDyadic(b),
                               BigDyadic(a) * BigDyadic(a) + BigDyadic(0x1p-1074)}) {
      expect_around_root(x);
    }
    EXPECT_TRUE(rational(root_bounds(BigDyadic(a) * BigDyadic(a)).lower) == mpq_class(a)) << a;
  }
  // At the ends of the binades, one bit off, and beyond all doubles.
  for (const double x : {0.25, 0.5, 1.0, 2.0, 4.0, 0x1p-1074, 0x1p-1022, 0x1p1023}) {
    for (const double off : {-1.0, 0.0, 1.0}) {
      const BigDyadic near = BigDyadic(x) + BigDyadic(x) * BigDyadic(off * 0x1p-52);
      expect_around_root(near);
      expect_around_root(near * BigDyadic(0x1p1000) * BigDyadic(0x1p1000));
      expect_around_root(BigDyadic(x) * (BigDyadic(1) + BigDyadic(off * 0x1p-300)));
    }
  }
}

/// arctan(1 / n) in units of 2^-400, to a few of them.
mpz_class arctangent(unsigned long n) {
  mpz_class power = 1, sum = 0;
  power <<= 400;
  power /= n;
  for (unsigned long k = 1; power != 0; k += 2) {
    sum += k % 4 == 1 ? mpz_class(power / k) : mpz_class(-(power / k));
    power /= n * n;
  }
  return sum;
}
TEST(RootBounds, HoldPi) {
  const mpq_class pi = mpq_class(4 * (4 * arctangent(5) - arctangent(239))) * power_of_two(-400),
                  doubt = power_of_two(-380);
  const auto [lower, upper] = pi_bounds();
  EXPECT_LT(rational(lower), pi - doubt);
  EXPECT_GT(rational(upper), pi + doubt);
  EXPECT_LT(rational(upper) - rational(lower), power_of_two(-208));
  const Ball ball = pi_ball();
  EXPECT_LT(abs(mpq_class(ball.high) + mpq_class(ball.low) - pi) + doubt, mpq_class(ball.radius));
}

}  // namespace
}  // namespace plumb
