// Numbers that carry a bound of their error, against rationals: arith/twofold.hpp and arith/approximate.hpp.
#include "plumb/arith/twofold.hpp"

#include <gtest/gtest.h>

#include "arith/samples.hpp"
#include "plumb/arith/approximate.hpp"

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
      const std::uint64_t which = entropy.below(8);
      if (which < 2) {
        x = x + by, y = y + approximately, exact += exact_by;
      } else if (which < 4) {
        x = x - by, y = y - approximately, exact -= exact_by;
      } else if (which < 6) {
        x = x * by, y = y * approximately, exact *= exact_by;
      } else if (which == 6 && exact_by != 0) {
        x = quotient(x, by), exact /= exact_by, y = {0, Ball::infinity, 1};
        quotients += x.reach() < Ball::infinity ? 1 : 0;
      } else if (which == 7 && exact > 0) {
        const auto r = root(x);
        const double reach = r.reach();
        if (reach < Ball::infinity) {
          ++roots;
          const mpq_class low = rational(r.high) + rational(r.low) - rational(reach);
          const mpq_class high = rational(r.high) + rational(r.low) + rational(reach);
          ASSERT_TRUE((low < 0 || low * low <= exact) && high * high >= exact);
        }
      }
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

TEST(TwofoldTest, TellsNothingOfWhatIsNone) {
  const double infinity = Ball::infinity;
  EXPECT_FALSE((Twofold<false>(infinity) + Twofold<false>(1)).nearest());
  EXPECT_FALSE((Twofold<false>(0x1p800) * Twofold<false>(0x1p800)).nearest());
  EXPECT_FALSE(quotient(Twofold<false>(1), Twofold<false>(0)).nearest());
  EXPECT_FALSE(root(Twofold<false>(-1)).nearest());
  EXPECT_FALSE((Twofold<false>(0x1p-700) * Twofold<false>(0x1.8p-374)).nearest());  // the last bit may be lost
  EXPECT_EQ(quotient(Twofold<false>(1), Twofold<false>(3)).nearest(), 1.0 / 3);
}

}  // namespace
}  // namespace plumb
