#include "plumb/arith/error_free.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "arith/samples.hpp"
#include "certify/sanitized.hpp"

namespace plumb {
namespace {

using samples::rational;

TEST(ErrorFreeTest, SumAndErrorAreExactUnlessTheSumOverflows) {
  Entropy entropy(1);
  const std::vector<double> special = samples::special_values();
  const auto check = [](double a, double b) {
    const Rounded s = two_sum(a, b);
    if (!(std::fabs(a + b) < samples::infinity)) return;
    ASSERT_EQ(s.value, a + b);
    ASSERT_TRUE(rational(s.value) + rational(s.error) == rational(a) + rational(b)) << std::hexfloat << a << ' ' << b;
  };
  for (const double a : special)
    for (const double b : special) check(a, b);
  for (int i = 0; i < battery::fitting(200'000) && !HasFatalFailure(); ++i) {
    const double a = samples::any_double(entropy);
    check(a, samples::any_double(entropy, a));
  }
}

TEST(ErrorFreeTest, ProductAndErrorAreExactInTheRange) {
  Entropy entropy(2);
  int inside = 0;
  const auto check = [&](double a, double b) {
    const double p = std::fabs(a * b);
    if (!(p >= 0x1p-960 && p <= 0x1p960) || std::fabs(a) >= 0x1p960 || std::fabs(b) >= 0x1p960) return;
    ++inside;
    const Rounded r = two_product(a, b);
    ASSERT_EQ(r.value, a * b);
    ASSERT_TRUE(rational(r.value) + rational(r.error) == rational(a) * rational(b)) << std::hexfloat << a << ' ' << b;
  };
  const std::vector<double> special = samples::special_values();
  for (const double a : special)
    for (const double b : special) check(a, b);
  for (int i = 0; i < battery::fitting(200'000) && !HasFatalFailure(); ++i) {
    check(samples::any_double(entropy), samples::any_double(entropy));
  }
  // The lower edge of the range, where the error is smallest.
  for (int i = 0; i < battery::fitting(20'000) && !HasFatalFailure(); ++i) {
    const auto mantissa = [&] { return 1 + static_cast<double>(entropy.bits(52)) * 0x1p-52; };
    const int e = static_cast<int>(entropy.within(950));
    check(std::ldexp(mantissa(), e), std::ldexp(mantissa(), -960 - e));
  }
  EXPECT_GT(inside, battery::fitting(60'000));
}

static_assert(two_sum(1, 0x1p-60).error == 0x1p-60);
static_assert(two_product(1 + 0x1p-30, 1 + 0x1p-30).error == 0x1p-60);

}  // namespace
}  // namespace plumb
