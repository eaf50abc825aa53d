#include "plumb/arith/interval.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "arith/samples.hpp"
#include "certify/sanitized.hpp"

namespace plumb {
namespace {

using samples::infinity;
using samples::rational;

// Between which doubles lies x, from outside: infinite beyond the largest.
bool not_below(double bound, const mpq_class& x) {
  return bound == infinity || (bound > -infinity && rational(bound) >= x);
}
bool not_above(double bound, const mpq_class& x) { return not_below(-bound, -x); }

// Some double between the bounds of an interval, ends included.
double inside(const Interval& i, Entropy& entropy) {
  switch (entropy.below(3)) {
    case 0:
      return i.lower;
    case 1:
      return i.upper;
    default: {  // any place between the two, in arithmetic that wraps
      const auto first = static_cast<std::uint64_t>(place_of(i.lower));
      const std::uint64_t distance = static_cast<std::uint64_t>(place_of(i.upper)) - first;
      return double_at(static_cast<std::int64_t>(first + entropy.below(distance + 1)));
    }
  }
}

testing::AssertionResult contains(const Interval& i, const mpq_class& x) {
  if (i.lower != i.lower || i.upper != i.upper) return testing::AssertionFailure() << "a bound is NaN";
  if (not_above(i.lower, x) && not_below(i.upper, x)) return testing::AssertionSuccess();
  return testing::AssertionFailure() << std::hexfloat << '[' << i.lower << ", " << i.upper << "] misses "
                                     << x.get_str();
}

// A point operation's interval: [x, x] when the exact result is a double, else bounds at most 2 ulps beyond its
// rounding.
testing::AssertionResult tight(const Interval& i, const mpq_class& x, bool transform_holds) {
  if (i.lower == -infinity || i.upper == infinity) {
    const bool large = abs(x) > rational(std::numeric_limits<double>::max()) - samples::power_of_two(970);
    return large ? testing::AssertionSuccess() : testing::AssertionFailure() << "infinite without need";
  }
  const double nearest = x.get_d();  // truncated: x lies between it and its neighbor away from zero
  if (transform_holds && rational(nearest) == x && (i.lower != nearest || i.upper != nearest)) {
    return testing::AssertionFailure() << "widened an exact result";
  }
  // Ulps of the rounded result, which may be a power of two above x.
  const double size = moved_by_ulps(std::fabs(nearest), 1);
  const mpq_class ulp = size < std::numeric_limits<double>::max() ? rational(moved_by_ulps(size, 1)) - rational(size)
                                                                  : samples::power_of_two(971);
  // Half an ulp by the rounding, and 2 by the step.
  if (2 * (x - rational(i.lower)) > 5 * ulp || 2 * (rational(i.upper) - x) > 5 * ulp) {
    return testing::AssertionFailure() << std::hexfloat << i.lower << " or " << i.upper << " lies too far out";
  }
  return testing::AssertionSuccess();
}

void check_pair(double a, double b) {
  SCOPED_TRACE(testing::Message() << std::hexfloat << a << " and " << b);
  const mpq_class qa = rational(a), qb = rational(b);
  const Interval ia{a}, ib{b};
  ASSERT_TRUE(contains(ia + ib, qa + qb));
  ASSERT_TRUE(contains(ia - ib, qa - qb));
  ASSERT_TRUE(contains(ia * ib, qa * qb));
  ASSERT_TRUE(tight(ia + ib, qa + qb, std::fabs(a + b) <= 0x1p1022));
  ASSERT_TRUE(tight(ia - ib, qa - qb, std::fabs(a - b) <= 0x1p1022));
  const double p = std::fabs(a * b);
  ASSERT_TRUE(
      tight(ia * ib, qa * qb,
            a == 0 || b == 0 || (p > 0x1p-960 && p < 0x1p960 && std::fabs(a) < 0x1p960 && std::fabs(b) < 0x1p960)));
}

TEST(IntervalTest, HoldsTheExactResultForAllPairsOfSpecialValues) {
  const std::vector<double> values = samples::special_values();
  for (const double a : values) {
    for (const double b : values) {
      check_pair(a, b);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(IntervalTest, HoldsTheExactResultOfRandomPairs) {
  Entropy entropy(1);
  for (int i = 0; i < battery::fitting(100'000); ++i) {
    const double a = samples::any_double(entropy), b = samples::any_double(entropy, a);
    check_pair(a, b);
    if (HasFatalFailure()) return;
  }
}

// Any interval, also one with infinite bounds, against numbers inside of it.
TEST(IntervalTest, HoldsEveryResultOfContainedNumbers) {
  Entropy entropy(2);
  const double largest = std::numeric_limits<double>::max();
  for (int i = 0; i < battery::fitting(100'000); ++i) {
    const auto any_interval = [&] {
      const double x = samples::any_double(entropy), y = samples::any_double(entropy, -x);
      return Interval{std::min(x, y), std::max(x, y)};
    };
    Interval a = any_interval(), b = any_interval();
    const double x = inside(a, entropy), y = inside(b, entropy);
    // An infinite bound stands for a finite number beyond all doubles.
    if (entropy.below(8) == 0) a.upper = infinity;
    if (entropy.below(8) == 0) b.lower = -infinity;
    const bool beyond = a.upper == infinity && entropy.coin();
    const mpq_class qx = beyond ? mpq_class(rational(largest) * 3) : rational(x), qy = rational(y);
    ASSERT_TRUE(contains(a + b, qx + qy)) << std::hexfloat << x << ' ' << y;
    ASSERT_TRUE(contains(a - b, qx - qy)) << std::hexfloat << x << ' ' << y;
    ASSERT_TRUE(contains(a * b, qx * qy)) << std::hexfloat << x << ' ' << y;
    ASSERT_TRUE(contains(b * a, qx * qy)) << std::hexfloat << x << ' ' << y;
    if (const auto s = (a * b).sign(); s.certain()) {
      ASSERT_EQ(s.value(), sign_of_number(mpq_class(qx * qy)));
    }
  }
}

TEST(IntervalTest, HoldsQuotientsAndRoots) {
  Entropy entropy(3);
  int finite = 0, tight_ones = 0;
  for (int i = 0; i < battery::fitting(100'000); ++i) {
    const double x = samples::any_double(entropy), y = samples::any_double(entropy, -x);
    const double u = samples::any_double(entropy), v = entropy.coin() ? u : samples::any_double(entropy, -u);
    Interval a{std::min(x, y), std::max(x, y)}, b{std::min(u, v), std::max(u, v)};
    if (entropy.coin()) a = Interval{x};
    const double n = inside(a, entropy), d = inside(b, entropy);
    if (d != 0) {
      ASSERT_TRUE(contains(quotient(a, b), rational(n) / rational(d))) << std::hexfloat << n << ' ' << d;
    }
    if (a.lower == a.upper && b.lower == b.upper && b.lower != 0 && n != 0 && std::fabs(n / d) > 0x1p-900 &&
        std::fabs(n / d) < 0x1p900) {
      const Interval q = quotient(a, b);
      ++finite;
      tight_ones += place_of(q.upper) - place_of(q.lower) <= 4;
    }
    if (n < 0) continue;
    const Interval r = root(a);  // lower^2 <= n <= upper^2
    ASSERT_TRUE(rational(r.lower) * rational(r.lower) <= rational(n)) << std::hexfloat << n;
    ASSERT_TRUE(r.upper == infinity || rational(r.upper) * rational(r.upper) >= rational(n)) << std::hexfloat << n;
    ASSERT_GE(r.lower, 0);
  }
  EXPECT_GT(finite, battery::fitting(5'000));
  EXPECT_EQ(tight_ones, finite);
  EXPECT_EQ(quotient(Interval{21}, Interval{-7}).lower, -3);
  EXPECT_EQ(quotient(Interval{21}, Interval{-7}).upper, -3);
  EXPECT_EQ(root(Interval{49}).lower, 7);
  EXPECT_EQ(root(Interval{49}).upper, 7);
  EXPECT_EQ(quotient(Interval{1}, Interval{0, 1}).upper, infinity);
}

// The extremes of a product come from the right bounds: no wider than the four products of the bounds.
TEST(IntervalTest, ProductIsNoWiderThanItsFourCornersNeed) {
  const std::vector<double> ends = {-3, -1, 0, 2, 5};
  for (const double al : ends)
    for (const double au : ends)
      for (const double bl : ends)
        for (const double bu : ends) {
          if (al > au || bl > bu) continue;
          const Interval p = Interval{al, au} * Interval{bl, bu};
          EXPECT_EQ(p.lower, std::min({al * bl, al * bu, au * bl, au * bu}));
          EXPECT_EQ(p.upper, std::max({al * bl, al * bu, au * bl, au * bu}));
        }
}

TEST(IntervalTest, KnowsItsSign) {
  EXPECT_EQ((Interval{1, 2}.sign()), Unsure{Sign::positive});
  EXPECT_EQ((Interval{-2, -1}.sign()), Unsure{Sign::negative});
  EXPECT_EQ((Interval{0, 0}.sign()), Unsure{Sign::zero});
  EXPECT_EQ((Interval{-0.0, 0}.sign()), Unsure{Sign::zero});
  EXPECT_FALSE((Interval{0, 1}.sign().certain()));
  EXPECT_FALSE((Interval{-1, 0}.sign().certain()));
  EXPECT_FALSE((Interval{-infinity, infinity}.sign().certain()));
}

static_assert((Interval{3} * Interval{5} - Interval{15}).sign() == Unsure{Sign::zero});
static_assert((Interval{0.1} * Interval{0.1}).lower < (Interval{0.1} * Interval{0.1}).upper);

}  // namespace
}  // namespace plumb
