// Numbers that carry a bound of their error, against rationals: arith/twofold.hpp,
// arith/approximate.hpp and arith/running_error.hpp.
#include "arith/twofold.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "arith/approximate.hpp"
#include "arith/running_error.hpp"
#include "arith/samples.hpp"

namespace plumb {
namespace {

using samples::rational;

template <bool Fma>
bool holds(const Twofold<Fma>& x, const mpq_class& exact) {
  const double reach = x.reach();
  if (!(reach < Ball::infinity) || !std::isfinite(x.high) || !std::isfinite(x.low)) return true;  // claims nothing
  // A subnormal bound is rounded: the guard makes every bound but that of nothing larger by far.
  return abs(exact - rational(x.high) - rational(x.low)) <= rational(reach) + rational(0x1p-1074) &&
         std::fabs(x.high) <= x.magnitude;
}

bool holds(const Approximate& x, const mpq_class& exact) {
  if (!(x.magnitude < Ball::infinity)) return true;
  const mpq_class most = rational(x.error + Approximate::slack) * rational(0x1p-53) * rational(x.magnitude);
  const auto sign = x.sign();
  return abs(exact - rational(x.value)) <= most + rational(0x1p-1074) &&
         (!sign.certain() || sign.value() == sign_of_number(sgn(exact)));
}

double draw(Entropy& entropy, bool extreme) {
  if (extreme) return entropy.coin() ? extreme_coordinate(entropy) : special_coordinate(entropy);
  return entropy.below(4) == 0 ? grid_coordinate(entropy, 8) : std::ldexp(wide_coordinate(entropy), -20);
}

template <bool Fma>
void run_chains(std::uint64_t start) {
  int roots = 0, quotients = 0, told = 0, steps = 0;
  for (std::uint64_t index = 0; index < 8'000; ++index) {
    SCOPED_TRACE(testing::Message() << "Entropy(" << start << ", " << index << ")");
    Entropy entropy(start, index);
    const bool extreme = entropy.below(3) == 0;
    const double a = draw(entropy, extreme), b = draw(entropy, extreme);
    auto x = Twofold<Fma>::difference(a, b);
    auto y = Approximate::difference(a, b);
    mpq_class exact = rational(a) - rational(b);
    for (int step = 0; step < 8; ++step, ++steps) {
      const double c = draw(entropy, extreme), d = draw(entropy, extreme);
      const auto by = Twofold<Fma>::difference(c, d) * Twofold<Fma>(d);
      const auto approximately = Approximate::difference(c, d) * Approximate(d);
      const mpq_class exact_by = (rational(c) - rational(d)) * rational(d);
      const std::uint64_t which = entropy.below(9);
      if (which < 2) {
        x = x + by, y = y + approximately, exact += exact_by;
      } else if (which < 4) {
        x = x - by, y = y - approximately, exact -= exact_by;
      } else if (which < 6) {
        x = x * by, y = y * approximately, exact *= exact_by;
      } else if (which == 8) {
        x = x.squared(), exact *= exact, y = y * y;
      } else if (which == 6 && exact_by != 0) {
        x = entropy.coin() ? quotient(x, by) : quotient_at_once(x, by), exact /= exact_by, y = {0, Ball::infinity, 1};
        quotients += x.reach() < Ball::infinity ? 1 : 0;
      } else if (which == 7 && exact > 0) {
        const auto r = entropy.coin() ? root(x) : root_at_once(x);
        const double reach = r.reach();
        if (reach < Ball::infinity && std::isfinite(r.low)) {
          ++roots;
          const mpq_class low = rational(r.high) + rational(r.low) - rational(reach);
          const mpq_class high = rational(r.high) + rational(r.low) + rational(reach);
          ASSERT_TRUE((low < 0 || low * low <= exact) && high * high >= exact);
        }
      }
      if (entropy.below(4) == 0) x = x.renewed(std::ldexp(1, static_cast<int>(entropy.below(40))));
      ASSERT_TRUE(holds(x, exact));
      ASSERT_TRUE(holds(y, exact));
      if (const auto nearest = x.nearest()) {
        ++told;
        const mpq_class off = abs(rational(*nearest) - exact);
        for (const int way : {-1, 1}) ASSERT_LE(off, abs(rational(Ball::next(*nearest, way)) - exact));
      }
    }
  }
  EXPECT_GT(roots, 400);
  EXPECT_GT(quotients, 400);
  EXPECT_GT(told, steps / 4);
}

TEST(TwofoldTest, HoldsTheExactResultOfChains) { run_chains<false>(1); }
TEST(TwofoldTest, HoldsItWithTheProductsErrorInOneInstruction) { run_chains<true>(2); }

template <bool Fma>
void run_roots_of_squares(std::uint64_t start) {
  using One = Twofold<Fma>;
  int roots = 0;
  for (std::uint64_t index = 0; index < 4'000; ++index) {
    SCOPED_TRACE(testing::Message() << "Entropy(" << start << ", " << index << ")");
    Entropy entropy(start, index);
    const bool extreme = entropy.below(3) == 0;
    One sum(0.0);
    mpq_class exact = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = draw(entropy, extreme), b = entropy.below(4) == 0 ? a : draw(entropy, extreme);
      const One x = One::difference(a, b);
      const mpq_class way = rational(a) - rational(b);
      sum = axis == 0 ? x * x : sum + x * x, exact += way * way;
    }
    const One r = root_of_squares(sum.below(sum.high + 4 * One::guard));
    const double reach = r.reach();
    if (!(reach < Ball::infinity) || !std::isfinite(r.low)) {
      EXPECT_FALSE(r.nearest());
      continue;
    }
    ++roots;
    const mpq_class middle = rational(r.high) + rational(r.low), low = middle - rational(reach),
                    high = middle + rational(reach);
    ASSERT_TRUE(low > 0 && low * low <= exact && high * high >= exact);
    ASSERT_LT(reach, r.high * 0x1p-98);  // it tells something
  }
  EXPECT_GT(roots, 2'000);
}

TEST(TwofoldTest, HoldsRootsOfSumsOfSquares) { run_roots_of_squares<false>(4), run_roots_of_squares<true>(5); }

/// u.v and u.v / v.v, the sizes of their terms by those of u.u and v.v.
template <bool Fma>
void run_quotients_by_squares(std::uint64_t start) {
  using One = Twofold<Fma>;
  int told = 0;
  for (std::uint64_t index = 0; index < 4'000; ++index) {
    SCOPED_TRACE(testing::Message() << "Entropy(" << start << ", " << index << ")");
    Entropy entropy(start, index);
    const bool extreme = entropy.below(3) == 0;
    One dot(0.0), of_u(0.0), of_v(0.0);
    Approximate plain(0.0);
    mpq_class exact_dot = 0, exact_of_v = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double a = draw(entropy, extreme), b = draw(entropy, extreme), c = draw(entropy, extreme),
                   d = entropy.below(4) == 0 ? c : draw(entropy, extreme);
      const One u = One::difference(a, b), v = One::difference(c, d);
      const mpq_class exact_u = rational(a) - rational(b), exact_v = rational(c) - rational(d);
      dot = dot + u * v, of_u = of_u + u * u, of_v = of_v + v * v;
      plain = plain + Approximate::difference(a, b) * Approximate::difference(c, d);
      exact_dot += exact_u * exact_v, exact_of_v += exact_v * exact_v;
    }
    const double guards = 4 * One::guard, size_of_v = of_v.high + guards, most = of_u.high + guards + size_of_v;
    ASSERT_TRUE(holds(dot.below(most), exact_dot));
    ASSERT_TRUE(holds(plain.below(most), exact_dot));
    const One t = quotient_by_squares(dot.below(most), of_v.below(size_of_v));
    if (!(t.reach() < Ball::infinity) || !std::isfinite(t.low)) {
      EXPECT_FALSE(t.nearest());
      continue;
    }
    ++told;
    ASSERT_TRUE(holds(t, exact_dot / exact_of_v));
    ASSERT_LT(t.reach(), 0x1p-90 * (1 + of_u.high / of_v.high));  // it tells something
  }
  EXPECT_GT(told, 2'000);
}

TEST(TwofoldTest, HoldsQuotientsBySumsOfSquares) {
  run_quotients_by_squares<false>(6), run_quotients_by_squares<true>(7);
}

TEST(TwofoldTest, TellsNothingOfWhatIsNone) {
  const double infinity = Ball::infinity;
  EXPECT_FALSE((Twofold<false>(infinity) + Twofold<false>(1)).nearest());
  EXPECT_FALSE((Twofold<false>(0x1p800) * Twofold<false>(0x1p800)).nearest());
  EXPECT_FALSE(quotient(Twofold<false>(1), Twofold<false>(0)).nearest());
  EXPECT_FALSE(root(Twofold<false>(-1)).nearest());
  EXPECT_FALSE((Twofold<false>(0x1p-700) * Twofold<false>(0x1.8p-374)).nearest());  // the last bit may be lost
  EXPECT_EQ(quotient(Twofold<false>(1), Twofold<false>(3)).nearest(), 1.0 / 3);
}

/// No claim where the bound is no number.
void expect_within(const Running& x, const mpq_class& exact, std::array<int, 4>& told) {
  const Unsure<Sign> sign = x.sign();
  if (sign.certain()) {
    ++told[static_cast<std::size_t>(static_cast<int>(sign.value()) + 1)];
    ASSERT_EQ(static_cast<int>(sign.value()), sgn(exact)) << std::hexfloat << x.value << " +- " << x.error;
  } else {
    ++told[3];
  }
  if (std::fabs(x.lower()) < samples::infinity) {
    ASSERT_LE(rational(x.lower()), exact);
  }
  if (std::fabs(x.upper()) < samples::infinity) {
    ASSERT_GE(rational(x.upper()), exact);
  }
  if (!(std::fabs(x.value) < samples::infinity && x.error < samples::infinity)) return;
  const mpq_class bound = rational(x.error) * (1 + samples::power_of_two(-39));
  ASSERT_LE(abs(exact - rational(x.value)), bound) << std::hexfloat << x.value << " +- " << x.error;
}

TEST(RunningTest, HoldsTheExactResultOfExpressions) {
  std::array<int, 4> told{};  // negative, zero, positive, unsure
  int overflown = 0, underflown = 0;
  for (std::uint64_t index = 0; index < 20'000; ++index) {
    SCOPED_TRACE(index);
    Entropy entropy(3, index);
    const bool extreme = entropy.below(3) == 0;
    std::array<Running, 6> x;
    std::array<mpq_class, 6> exact;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double other = i == 0 ? 0 : x[i - 1].value;
      const double drawn = extreme ? samples::any_double(entropy, other) : std::ldexp(wide_coordinate(entropy), -20);
      x[i] = Running(drawn), exact[i] = rational(drawn);
    }
    for (int step = 0; step < 12; ++step) {
      const std::size_t i = entropy.below(x.size()), j = entropy.below(x.size()), to = entropy.below(x.size());
      switch (entropy.below(7)) {
        case 3:
          if (exact[j] == 0) continue;
          x[to] = quotient(x[i], x[j]), exact[to] = exact[i] / exact[j];
          break;
        case 0:
          x[to] = x[i] + x[j], exact[to] = exact[i] + exact[j];
          break;
        case 1:
          x[to] = x[i] - x[j], exact[to] = exact[i] - exact[j];
          break;
        case 2:
          x[to] = magnitude(x[i]), exact[to] = abs(exact[i]);
          break;
        default:
          x[to] = x[i] * x[j], exact[to] = exact[i] * exact[j];
      }
      expect_within(x[to], exact[to], told);
      if (HasFatalFailure()) return;
      if (!(std::fabs(x[to].value) < samples::infinity)) {
        ++overflown;
        break;
      }
      underflown += x[to].value == 0 && exact[to] != 0;
    }
  }
  std::printf("negative %d, zero %d, positive %d, unsure %d; overflown %d, underflown %d\n", told[0], told[1], told[2],
              told[3], overflown, underflown);
  for (const int count : told) EXPECT_GT(count, 3'000);
  EXPECT_GT(overflown, 1'000);
  EXPECT_GT(underflown, 1'000);
}

TEST(RunningTest, HoldsTheExactResultForAllPairsOfSpecialValues) {
  std::array<int, 4> told{};
  for (const double a : samples::special_values()) {
    for (const double b : samples::special_values()) {
      SCOPED_TRACE(testing::Message() << std::hexfloat << a << " and " << b);
      expect_within(Running(a) + Running(b), rational(a) + rational(b), told);
      expect_within(Running(a) - Running(b), rational(a) - rational(b), told);
      expect_within(Running(a) * Running(b), rational(a) * rational(b), told);
      if (b != 0) expect_within(quotient(Running(a), Running(b)), rational(a) / rational(b), told);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(RunningTest, KeepsItsBoundOverLongSums) {
  for (std::uint64_t index = 0; index < 20; ++index) {
    SCOPED_TRACE(index);
    Entropy entropy(4, index);
    std::array<int, 4> told{};
    Running sum(0.0);
    mpq_class exact = 0;
    for (int i = 0; i < 1'000; ++i) {  // 2^11 operations together
      const double a = unit_coordinate(entropy), b = unit_coordinate(entropy);
      sum = sum + Running(a) * Running(b);
      exact += rational(a) * rational(b);
    }
    expect_within(sum, exact, told);
    expect_within(sum - Running(exact.get_d()), exact - rational(exact.get_d()), told);
    EXPECT_LT(sum.error, 0x1p-35);
  }
}

}  // namespace
}  // namespace plumb
