// Are signs with square roots of numbers exact, whatever the numbers?
#include "plumb/certify/radical.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/space_cases.hpp"
#include "oracle/radicals.hpp"

namespace plumb::space_cases {
namespace {

using Numbers = std::array<double, 5>;

oracle::Radicals rational(const Numbers& x) { return {x[0], x[1], x[2], x[3], x[4]}; }

std::string shown(const Numbers& x) {
  std::string text;
  for (const double number : x) text.append(" ").append(hexadecimal(number));
  return text;
}

TEST(RadicalTest, MeansWhatItSays) {
  EXPECT_EQ(sign_of_radical(-3, 1, 9), Sign::zero);
  EXPECT_EQ(sign_of_radical(-3, 1, std::nextafter(9, 10)), Sign::positive);
  EXPECT_EQ(sign_of_radical(3, -1, std::nextafter(9, 10)), Sign::negative);
  EXPECT_EQ(sign_of_radical(-3, 1, std::nextafter(9, 8)), Sign::negative);
  EXPECT_EQ(sign_of_radical(0, 5, 0), Sign::zero);
  EXPECT_EQ(sign_of_radical(0, -5, 0x1p-1074), Sign::negative);
  EXPECT_EQ(sign_of_radical(-0.0, 0, 4), Sign::zero);
  EXPECT_EQ(sign_of_radical(-0x1p-1074, 1, 0), Sign::negative);
  EXPECT_EQ(sign_of_radical(-0x1p-537, 1, 0x1p-1074), Sign::zero);
  EXPECT_EQ(sign_of_radical(0x1p1023, -0x1p1023, 1), Sign::zero);
  EXPECT_EQ(sign_of_radical(-1, 0x1p-512, 0x1p1023), Sign::negative);  // its term is 2^-0.5
  EXPECT_EQ(sign_of_radicals(-5, 1, 9, 1, 4), Sign::zero);
  EXPECT_EQ(sign_of_radicals(0, 1, 8, -2, 2), Sign::zero);  // sqrt(8) = 2 sqrt(2)
  EXPECT_EQ(sign_of_radicals(0, 1, std::nextafter(8, 9), -2, 2), Sign::positive);
  EXPECT_EQ(sign_of_radicals(1, 1, 2, -1, 6), Sign::negative);  // 2.4142 against 2.4495
  EXPECT_EQ(sign_of_radicals(1, 1, 2, -1, 5), Sign::positive);  // against 2.2361
  // (sqrt(2) + sqrt(3))^2 = 5 + 2 sqrt(6), whose root no double holds.
  EXPECT_EQ(sign_of_radicals(-std::sqrt(5 + 2 * std::sqrt(6.0)), 1, 2, 1, 3),
            oracle::digits_sign(rational({-std::sqrt(5 + 2 * std::sqrt(6.0)), 1, 2, 1, 3})));
}

// Both functions, by both judges, with the laws.
void check(const Numbers& x, Shares& one, Shares& two, bool ask_cgal) {
  const auto& [a, b, c, d, e] = x;
  const Sign first = oracle::digits_sign(rational({a, b, c, 0, 0})), both = oracle::digits_sign(rational(x));
  if (ask_cgal) {
    ASSERT_EQ(oracle::cgal_sign(rational(x)), both) << "the judges disagree at" << shown(x);
  }
  ASSERT_EQ(sign_of_radical(a, b, c), one(first)) << shown(x);
  ASSERT_EQ(sign_of_radicals(a, b, c, d, e), two(both)) << shown(x);
  ASSERT_EQ(sign_of_radical(-a, -b, c), -first) << shown(x);
  ASSERT_EQ(sign_of_radicals(-a, -b, c, -d, e), -both) << shown(x);
  ASSERT_EQ(sign_of_radicals(a, d, e, b, c), both) << shown(x);
  ASSERT_EQ(sign_of_radicals(a, b, c, 0, e), first) << shown(x);
}

TEST(RadicalTest, IsExactOnGrids) {
  Shares one, two;
  for (std::uint64_t i = 0; i < 10'000 * more; ++i) {
    Entropy entropy(71, i);
    const std::int64_t most = std::int64_t{2} << i % 4;
    const auto any = [&] { return static_cast<double>(entropy.within(most)); };
    // Radicands whose roots lie in one field: squares times 1, 2 or 3.
    const double m = static_cast<double>(1 + entropy.below(3)), n = static_cast<double>(1 + entropy.below(3));
    const double r = any(), s = any();
    Numbers x{any(), any(), r * r * m, any(), s * s * n};
    if (i % 5 == 0) x = {any(), x[1], r * r, x[3], s * s};  // integer roots
    if (i % 10 == 0) x[0] = -x[1] * std::fabs(r);
    if (i % 10 == 5) x[0] = -x[1] * std::fabs(r) - x[3] * std::fabs(s);
    if (i % 5 == 1)
      x = {i % 10 == 1 ? 0 : x[0], x[1] * std::fabs(s), x[2], -x[1] * std::fabs(r), s * s * m};  // no roots left
    check(x, one, two, i % 2 == 0);
  }
  EXPECT_GT(one.least(), 0.1);
  EXPECT_GT(two.least(), 0.1);
}

TEST(RadicalTest, IsExactOnEveryFamily) {
  Shares one, two;
  on_families(2, 250, [&](const std::vector<Point3>& p) {
    check({p[0].x, p[0].y, std::fabs(p[0].z), p[1].x, std::fabs(p[1].y)}, one, two, false);
  });
  EXPECT_GT(one.of(Sign::negative), 0.2);
  EXPECT_GT(one.of(Sign::positive), 0.2);
  EXPECT_GT(two.of(Sign::negative), 0.2);
  EXPECT_GT(two.of(Sign::positive), 0.2);
}

// Sums that all but vanish: a is the double nearest to minus the rest, and its neighbors; or exactly the rest.
TEST(RadicalTest, IsExactWhereTermsCancel) {
  Shares one, two;
  int undecided = 0;
  for (std::uint64_t i = 0; i < 4000 * more; ++i) {
    Entropy entropy(72, i);
    const auto number = [&] {
      return i % 3 == 0 ? wide_coordinate(entropy) : static_cast<double>(entropy.within(999));
    };
    double b = number(), c = std::fabs(number()), d = number(), e = std::fabs(number());
    if (i % 5 == 1) e = 4 * c;  // the same root, doubled
    if (i % 5 == 1 && i % 2 == 0) d = -b / 2;
    double a = -(b * std::sqrt(c) + (i % 2 == 0 ? 0 : d * std::sqrt(e)));
    a = moved_by_ulps(a, entropy.within(2));
    check({a, b, c, d, e}, one, two, i % 8 == 0);
    undecided += static_cast<int>(std::fabs(a + b * std::sqrt(c)) <= 0x1p-51 * std::fabs(a));
  }
  EXPECT_GT(undecided, 1000);
  EXPECT_GT(std::min(one.of(Sign::negative), one.of(Sign::positive)), 0.2);
  EXPECT_GT(std::min(two.of(Sign::negative), two.of(Sign::positive)), 0.2);
}

TEST(RadicalTest, IsExactAtTheEndsOfTheFormat) {
  Shares one, two;
  for (std::uint64_t i = 0; i < 800 * more; ++i) {
    Entropy entropy(73, i);
    const auto number = [&] { return extreme_coordinate(entropy); };
    double a = number(), b = number(), c = std::fabs(number()), d = number(), e = std::fabs(number());
    if (i % 2 == 0) {
      const double term = -b * std::sqrt(c);
      if (std::isfinite(term)) a = moved_by_ulps(term, entropy.within(1));
    }
    if (i % 4 == 0) e = c, d = moved_by_ulps(-b, entropy.within(1));
    check({a, b, c, d, e}, one, two, false);
  }
  EXPECT_GT(one.of(Sign::negative), 0.2);
  EXPECT_GT(one.of(Sign::positive), 0.2);
}

TEST(RadicalTest, RefusesWhatIsNoRealNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    for (std::size_t i = 0; i < 5; ++i) {
      Numbers x{1, 2, 3, 4, 5};
      x[i] = bad;
      EXPECT_THROW(sign_of_radicals(x[0], x[1], x[2], x[3], x[4]), NonFinite) << i;
      if (i < 3) {
        EXPECT_THROW(sign_of_radical(x[0], x[1], x[2]), NonFinite) << i;
      }
    }
  }
  try {
    sign_of_radical(1, 2, -0x1p-1074);
    FAIL() << "took the root of a negative number";
  } catch (const NegativeRadicand& e) {
    EXPECT_STREQ(e.what(), "the radicand c is negative and has no real root; give one that is zero or positive");
  }
  EXPECT_THROW(sign_of_radical(1, 0, -1), NegativeRadicand);
  EXPECT_THROW(sign_of_radicals(1, 1, 1, 0, -1), NegativeRadicand);
  try {
    sign_of_radicals(1, 2, 3, infinity, 5);
    FAIL() << "took infinity for a number";
  } catch (const NonFinite& e) {
    EXPECT_STREQ(e.what(), "sign_of_radicals: d is inf, not a real number; give a finite double");
  }
}

}  // namespace
}  // namespace plumb::space_cases
