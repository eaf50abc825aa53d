#include "plumb/arith/lattice_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plumb/arith/big.hpp"
#include "plumb/certify/plan.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/predicates/manifest.hpp"

namespace plumb {
namespace {

using namespace predicates;

// Integers of at most `bits` bits: the extremes and their neighbors more often than others.
double coordinate(Entropy& e, int bits) {
  const double most = certify::planned::largest_of(bits);
  const double m =
      std::max(0.0, e.coin() ? most - static_cast<double>(e.below(3)) : std::floor(most * unit_coordinate(e)));
  return e.coin() ? m : -m;
}

template <Formula F>
mpq_class exact_value(const Coordinates<F>& p) {
  return evaluate<F>([&](std::size_t i) { return big_rational(p[i]); }).value;
}

template <class F>
class LatticeErrorTest : public testing::Test {};
using Formulas = testing::Types<Orient2d, Orient3d, InCircle, InSphere>;
TYPED_TEST_SUITE(LatticeErrorTest, Formulas);

TYPED_TEST(LatticeErrorTest, BoundsTheErrorOfDoubles) {
  using F = TypeParam;
  for (int bits = 0; bits <= arith::lattice_word::double_bits; ++bits) {
    const LatticeError bound = certify::planned::error<F>(bits);
    const mpq_class most(bound.error), largest(bound.largest);
    for (std::uint64_t i = 0; i < 400; ++i) {
      Entropy e(static_cast<std::uint64_t>(bits), i);
      Coordinates<F> p{};
      for (double& x : p) x = coordinate(e, bits);
      const double value = F{}(p);
      const mpq_class exact = exact_value<F>(p);
      ASSERT_TRUE(abs(exact) <= largest) << bits << ' ' << i;
      ASSERT_TRUE(abs(mpq_class(value) - exact) <= most) << bits << ' ' << i;
      if (std::fabs(value) > bound.root) {
        ASSERT_EQ(sgn(exact), value > 0 ? 1 : -1) << bits << ' ' << i;
      } else {
        ASSERT_TRUE(abs(exact) <= 2 * mpq_class(bound.root)) << bits << ' ' << i;
        if (bound.root == 0) {
          ASSERT_EQ(sgn(exact), 0) << bits << ":" << i;
        }
      }
    }
  }
}

TYPED_TEST(LatticeErrorTest, IsNoMoreCarefulThanFactorsOfTen) {  // at 40 bits, where nearly every operation rounds
  using F = TypeParam;
  mpq_class worst = 0;
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    Entropy e(40, i);
    Coordinates<F> p{};
    for (double& x : p) x = coordinate(e, 40);
    worst = std::max(worst, mpq_class(abs(mpq_class(F{}(p)) - exact_value<F>(p))));
  }
  const mpq_class bound(certify::planned::error<F>(40).error);
  EXPECT_TRUE(worst < bound);
  EXPECT_TRUE(100 * worst > bound);
}

TEST(LatticeErrorTest, IntegersBelow2To53AreExact) {
  const auto a = LatticeError::coordinate(0x1p26), b = LatticeError::coordinate(0x1p26 - 1);
  EXPECT_EQ((a * b).error, 0);
  EXPECT_GT((a * a + a * a).error, 0);  // up to 2^53, where the neighbors are no doubles
  const LatticeError edge = LatticeError::coordinate(0x1p53 - 2) + LatticeError::coordinate(1);
  EXPECT_EQ(edge.error, 0);
  EXPECT_EQ(edge.largest, 0x1p53 - 1);
  const LatticeError beyond = LatticeError::coordinate(0x1p53 - 2) + LatticeError::coordinate(3);
  EXPECT_GT(beyond.error, 0);  // 2^53 + 1 is no double
  EXPECT_EQ(beyond.root, 0);   // but rounds away from no sign
  EXPECT_GE((beyond + beyond).root, 2.0);
}

TEST(LatticeErrorTest, EndsAsInfiniteWhereItLeavesTheDoubles) {
  LatticeError x = LatticeError::coordinate(0x1p62);
  for (int i = 0; i < 5; ++i) x = x * x;
  EXPECT_TRUE(std::isinf(x.root));
  EXPECT_TRUE(std::isinf((x + x).root) && std::isinf((x * x).root) && std::isinf((x - x).root));
  EXPECT_TRUE(std::isinf((LatticeError::coordinate(1) * x).root));
}

}  // namespace
}  // namespace plumb
