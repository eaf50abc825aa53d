// Is a formula that the manifest does not know decided exactly?  The one of docs/add_a_predicate.md, instantiated here,
// against rational arithmetic.
#include <gtest/gtest.h>

#include <limits>

#include "docs/in_diametral_circle.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/decide.hpp"
#include "plumb/degenerate/points.hpp"

namespace plumb::docs {
namespace {

using Formula = mine::InDiametralCircle;

Sign in_rationals(const Coordinates<Formula>& p) {
  return evaluate<Formula>([&](std::size_t i) { return big_rational(p[i]); }).sign();
}

Coordinates<Formula> with(double cx, double cy) {
  return {-500000000000005, -157079632679485, 500000000000005, 157079632679485, cx, cy};
}

TEST(OwnFormula, MeansWhatThePageSays) {
  EXPECT_EQ(decide<Formula>({0, 0, 2, 0, 1, 0.5}), Sign::positive);
  EXPECT_EQ(decide<Formula>({0, 0, 2, 0, 1, -2}), Sign::negative);
  EXPECT_EQ(decide<Formula>({0, 0, 2, 0, 1, 1}), Sign::zero);
  EXPECT_EQ(decide<Formula>({0, 0, 2, 0, 2, 0}), Sign::zero);
  EXPECT_EQ(decide<Formula>(with(174336293856415, 494247779607695)), Sign::zero);
}

TEST(OwnFormula, EveryStageIsExactOnEveryFamily) {
  StageCounts all;
  for (const FamilyInfo& info : families) {
    std::array<int, 3> signs{};
    for (std::uint64_t i = 0; i < 3000; ++i) {
      Entropy entropy(11, i);
      // Three points of a set of which all four lie on one circle: now and then a right angle.
      Coordinates<Formula> p = coordinates2<3>(info.family, Degeneracy::cocircular, entropy);
      if (i % 3 == 0) {  // Thales: a and b opposite with respect to the origin, c the image of a by a quarter turn
        p[2] = -p[0], p[3] = -p[1], p[4] = -p[1], p[5] = p[0];
      }
      const Sign truth = in_rationals(p);
      ++signs[static_cast<std::size_t>(static_cast<int>(truth) + 1)];
      ASSERT_EQ(decide<Formula>(p, all), truth) << info.name << ' ' << i;
      const int filtered = filter<Formula>(p);
      ASSERT_TRUE(filtered == 0 || filtered == static_cast<int>(truth)) << info.name << ' ' << i;
      for (const Unsure<Sign> s : {structural_zero_sign<Formula>(p), integer_sign<Formula>(p),
                                   interval_sign<Formula>(p), wide_integer_sign<Formula>(p)}) {
        ASSERT_TRUE(!s.certain() || s.value() == truth) << info.name << ' ' << i;
      }
      ASSERT_EQ(big_integer_sign(certify::tape::program<Formula>(), p), truth) << info.name << ' ' << i;
    }
    // Representative: insides, outsides and zeros; but of repeated points c is one (zero), or a is b (outside).
    for (std::size_t k = 0; k < signs.size(); ++k) {
      EXPECT_TRUE(signs[k] > 100 || (info.family == Family::repeated && k == 2)) << info.name << ' ' << k;
    }
  }
  EXPECT_GT(all.of(Stage::filter), 0u);
  EXPECT_GT(all.of(Stage::integer), 0u);
  EXPECT_GT(all.of(Stage::big_integer), 0u);
}

TEST(OwnFormula, RefusesWhatIsNoNumber) {
  try {
    decide<Formula>(with(0, std::numeric_limits<double>::quiet_NaN()));
    FAIL() << "a NaN was taken for a number";
  } catch (const NonFinite& e) {
    EXPECT_STREQ(e.what(), "in_diametral_circle: c.y is nan, not a real number; give a finite double");
  }
}

}  // namespace
}  // namespace plumb::docs
