// Laws of certify/rounded.hpp, against rationals: each rounding of values, quotients and roots, from hard arguments.
#include "certify/rounded.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "arith/big_rounding.hpp"
#include "arith/samples.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate.hpp"

namespace plumb {
namespace {

using samples::infinity, samples::rational;

constexpr std::array ways{Rounding::down, Rounding::nearest, Rounding::up};
constexpr double largest = std::numeric_limits<double>::max();

/// Sign of r - x, where x may be a root: `below(q)` says how q compares with x.
template <class Compare>
testing::AssertionResult is_rounded(Rounding way, double r, Compare compare) {
  const auto fail = [&] { return testing::AssertionFailure() << std::hexfloat << r; };
  if (r == 0 && std::signbit(r)) return fail() << " is a negative zero";
  const auto against = [&](double x) -> int {
    if (x == infinity) return 1;
    if (x == -infinity) return -1;
    return compare(rational(x));
  };
  const int s = against(r);
  if (s == 0) return testing::AssertionSuccess();
  const double next = s > 0 ? std::nextafter(r, -infinity) : std::nextafter(r, infinity);  // beyond the exact value
  if (against(next) == s) return fail() << " is not beside the exact value";
  if (way == Rounding::down) return s < 0 ? testing::AssertionSuccess() : fail() << " is above";
  if (way == Rounding::up) return s > 0 ? testing::AssertionSuccess() : fail() << " is below";
  // As if the largest double had a finite neighbor.
  const auto place = [](double x) {
    return std::fabs(x) < infinity ? rational(x) : mpq_class((x > 0 ? 1 : -1) * samples::power_of_two(1024));
  };
  const int half = compare((place(r) + place(next)) / 2);
  const bool even = (std::bit_cast<std::uint64_t>(r) & 1) == 0;
  if (half == 0) return even ? testing::AssertionSuccess() : fail() << " is odd";
  return half == s ? fail() << " is not the nearest" : testing::AssertionSuccess();
}

auto against(const mpq_class& exact) {
  return [exact](const mpq_class& x) { return cmp(x, exact); };
}
auto against_root(const mpq_class& radicand) {
  return [radicand](const mpq_class& x) { return x < 0 ? -1 : cmp(mpq_class(x * x), radicand); };
}

constexpr auto numerator = [](auto a, auto b, auto c, auto d) { return a * b - c * d; };
constexpr auto denominator = [](auto a, auto b, auto c, auto d) { return a * c + b * d; };

std::array<double, 4> arguments(Entropy& entropy) {
  std::array<double, 4> p{};
  switch (entropy.below(3)) {
    case 0:
      fill_points(any_family(entropy), Degeneracy::collinear, 2, p, entropy);
      break;
    case 1:
      for (double& x : p) x = grid_coordinate(entropy, 4);
      break;
    default:
      for (double& x : p) x = samples::any_double(entropy, p[0]);
  }
  return p;
}

TEST(RoundedTest, IsTheDoubleThatTheRoundingNames) {
#ifdef PLUMB_LONG_TESTS
  constexpr std::uint64_t cases = 2'000'000;
#else
  constexpr std::uint64_t cases = 20'000;
#endif
  int exact = 0, infinite = 0, subnormal = 0, roots = 0;
  for (std::uint64_t index = 0; index < cases; ++index) {
    Entropy entropy(21, index);
    const std::array<double, 4> p = arguments(entropy);
    const auto [a, b, c, d] = std::array{rational(p[0]), rational(p[1]), rational(p[2]), rational(p[3])};
    const mpq_class n = a * b - c * d, m = a * c + b * d;
    SCOPED_TRACE(testing::Message() << "case " << index << std::hexfloat << ": " << p[0] << ' ' << p[1] << ' ' << p[2]
                                    << ' ' << p[3]);
    for (const Rounding way : ways) {
      const double value = rounded_value(way, numerator, p);
      ASSERT_TRUE(is_rounded(way, value, against(n)));
      infinite += std::isinf(value);
      subnormal += value != 0 && std::fabs(value) < 0x1p-1022;
      if (n >= 0) {
        ASSERT_TRUE(is_rounded(way, rounded_root(way, numerator, p), against_root(n)));
      }
      if (m == 0) continue;
      const mpq_class q = n / m;
      exact += std::fabs(value) < infinity && rational(value) == n;
      ASSERT_TRUE(is_rounded(way, rounded_quotient(way, numerator, denominator, p), against(q)));
      if (q >= 0) {
        ++roots;
        ASSERT_TRUE(is_rounded(way, rounded_root_of_quotient(way, numerator, denominator, p), against_root(q)));
      }
    }
  }
  EXPECT_GT(exact, 100);
  EXPECT_GT(infinite, 100);
  EXPECT_GT(subnormal, 100);
  EXPECT_GT(roots, 1000);
}

// The integers by themselves, which the pairs of doubles above seldom leave anything to.
TEST(RoundedTest, IntegersRoundAsAsked) {
  for (std::uint64_t index = 0; index < 20'000; ++index) {
    Entropy entropy(22, index);
    const double a = samples::any_double(entropy), b = samples::any_double(entropy, a),
                 c = samples::any_double(entropy);
    SCOPED_TRACE(testing::Message() << "case " << index << std::hexfloat << ": " << a << ' ' << b << ' ' << c);
    const BigDyadic n = BigDyadic(a) * BigDyadic(b), d(c);
    const mpq_class qn = rational(a) * rational(b), qd = rational(c);
    for (const Rounding way : ways) {
      ASSERT_TRUE(is_rounded(way, rounded(way, n), against(qn)));
      if (qd == 0) continue;
      ASSERT_TRUE(is_rounded(way, rounded_quotient(way, n, d), against(qn / qd)));
      if (qn / qd >= 0) {
        ASSERT_TRUE(is_rounded(way, rounded_root(way, n, d), against_root(qn / qd)));
      }
    }
  }
}

TEST(RoundedTest, StaysWithinDoublesTowardZero) {
  constexpr auto product = [](auto a, auto b) { return a * b; };
  EXPECT_EQ(rounded_value(Rounding::down, product, largest, 2.0), largest);
  EXPECT_EQ(rounded_value(Rounding::up, product, largest, 2.0), infinity);
  EXPECT_EQ(rounded_value(Rounding::nearest, product, largest, 2.0), infinity);
  EXPECT_EQ(rounded_value(Rounding::up, product, largest, -2.0), -largest);
  EXPECT_EQ(rounded_value(Rounding::up, product, 0x1p-1074, 0.5), 0x1p-1074);
  EXPECT_EQ(rounded_value(Rounding::down, product, 0x1p-1074, 0.5), 0);
  EXPECT_EQ(rounded_value(Rounding::down, product, 0x1p-1074, -0.5), -0x1p-1074);
}

TEST(RoundedTest, RefusesWhatIsNoNumber) {
  EXPECT_THROW((void)rounded_value(Rounding::nearest, numerator, 1.0, std::nan(""), 1.0, 1.0), NonFinite);
  EXPECT_THROW((void)rounded_quotient(Rounding::up, numerator, denominator, 1.0, infinity, 1.0, 1.0), NonFinite);
}

}  // namespace
}  // namespace plumb
