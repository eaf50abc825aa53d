// Signs of sums of roots, against floating point of two thousand bits and against sums that are zero by construction.
#include "arith/root_sum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace plumb {
namespace {

Sign by_many_bits(const std::vector<RootTerm>& terms) {
  constexpr unsigned bits = 2048;
  mpf_class sum(0, bits);
  for (const RootTerm& t : terms) {
    const mpf_class radicand(mpf_class(big_rational(t.radicand).value, 4 * bits));
    mpf_class root(0, bits);
    mpf_sqrt(root.get_mpf_t(), radicand.get_mpf_t());
    sum += t.times * root;
  }
  mpf_class least(1, bits);
  mpf_div_2exp(least.get_mpf_t(), least.get_mpf_t(), 1500);
  return abs(sum) < least ? Sign::zero : sign_of_number(sgn(sum));
}

TEST(RootSum, AsManyBitsSay) {
  int zeros = 0;
  for (std::uint32_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::vector<RootTerm> terms;
    const int range = seed % 2 == 0 ? 12 : 1000;
    for (std::uint64_t i = random() % 9; i-- > 0;)
      terms.push_back(
          {int(random() % 5) - 2, BigDyadic(std::ldexp(double(int(random()) & 1023) * range, -int(random() % 9)))});
    if (seed % 3 == 0) {  // what is there once more, as multiples of the roots of four and nine times as much
      const std::vector<RootTerm> before = terms;
      for (const RootTerm& t : before) {
        terms.push_back({-2 * t.times, t.radicand});
        terms.push_back({t.times, t.radicand * BigDyadic(9)});
        terms.push_back({-t.times, t.radicand * BigDyadic(4)});
      }
    }
    const Sign s = sign_of_root_sum(terms);
    EXPECT_EQ(s, by_many_bits(terms));
    zeros += s == Sign::zero;
    std::vector<RootTerm> negated;
    for (const RootTerm& t : terms) negated.insert(negated.begin(), {-t.times, t.radicand});
    EXPECT_EQ(sign_of_root_sum(negated), -s);
  }
  EXPECT_GT(zeros, 130);
}

TEST(RootSum, NearZeroAndFarApart) {
  const auto root = [](int times, double x) { return RootTerm{times, BigDyadic(x)}; };
  EXPECT_EQ(sign_of_root_sum({}), Sign::zero);
  EXPECT_EQ(sign_of_root_sum(std::vector{root(1, 2), root(1, 8), root(-1, 18)}), Sign::zero);
  EXPECT_EQ(sign_of_root_sum(std::vector{root(3, 0x1p-1074), root(-3, 0x1p-1072), root(3, 0x1p-1074)}), Sign::zero);
  EXPECT_EQ(sign_of_root_sum(std::vector{root(1, 0x1p1000), root(1, 0x1p-1074), root(-1, 0x1p1000)}), Sign::positive);
  EXPECT_EQ(sign_of_root_sum(std::vector{root(1, 0x1p1000), root(1, 0x1p-1074), root(-1, 0x1.0000000000001p1000)}),
            Sign::negative);
  // sqrt(n + 1) + sqrt(n - 1) is less than 2 sqrt(n), by some n to the power -3/2 / 4.
  EXPECT_EQ(sign_of_root_sum(std::vector{root(1, 0x1p52 + 1), root(1, 0x1p52 - 1), root(-2, 0x1p52)}), Sign::negative);
}

}  // namespace
}  // namespace plumb
