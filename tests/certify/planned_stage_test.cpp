// Which stage answers where a plan has a bound: shares as promised, and the sign of decide whichever it was.
#include <gtest/gtest.h>

#include <cmath>

#include "certify/lattice_cases.hpp"

namespace plumb {
namespace {

using namespace lattice_cases;
using namespace predicates;
using certify::planned::PlanStage;

struct StageShares {
  std::array<std::uint64_t, 4> count{};
  void decided(PlanStage s) { ++count[static_cast<std::size_t>(s)]; }
  [[nodiscard]] double percent(PlanStage s) const {
    return 100 * static_cast<double>(count[static_cast<std::size_t>(s)]) /
           static_cast<double>(count[0] + count[1] + count[2] + count[3]);
  }
};

constexpr std::uint64_t cases = 2'000;

/// Points of a unit cube, all 53 bits of each coordinate used, scaled by 2^exponent; `degenerate`: exactly so.
template <Formula F>
Coordinates<F> cube(std::uint64_t i, int exponent, bool degenerate) {
  Entropy e(18, i);
  Coordinates<F> p{};
  if (degenerate) {
    fill_exact(F::dimension == 3 ? Degeneracy::coplanar : Degeneracy::collinear, F::dimension, 50, p, e);
    for (double& x : p) x = std::ldexp(x, -51);
  } else {
    for (double& x : p) x = std::ldexp(static_cast<double>(e.bits(53)), -53);
  }
  for (double& x : p) x = std::ldexp(x, exponent);
  return p;
}

/// Of `cases` sets, with the lattice that they and one coordinate beside them need.
template <Formula F>
StageShares shares(int exponent, bool degenerate, double beside = 0) {
  std::vector<double> all{beside};
  for (std::uint64_t i = 0; i < cases; ++i) {
    const auto p = cube<F>(i, exponent, degenerate);
    all.insert(all.end(), p.begin(), p.end());
  }
  const Lattice lattice = lattice_of(all);
  const Kernel kernel(lattice);
  StageShares shares;
  for (std::uint64_t i = 0; i < cases; ++i) {
    const auto p = cube<F>(i, exponent, degenerate);
    kernel.with<F>([&](const auto& sign) {
      [&]<std::size_t... I>(std::index_sequence<I...>) {
        EXPECT_EQ(sign.recorded(shares, kernel.point(argument<F, I>(p))...), decide<F>(p)) << described<F>(lattice, p);
      }
      (std::make_index_sequence<arguments<F>.size()>{});
    });
  }
  return shares;
}

template <class F>
class PlannedStageTest : public testing::Test {};
using Bounded = testing::Types<Orient2d, Orient3d, InCircle>;
TYPED_TEST_SUITE(PlannedStageTest, Bounded);

TYPED_TEST(PlannedStageTest, TheBoundTellsPointsAllOverTheScene) {
  using F = TypeParam;
  for (const int exponent : {0, -200, 200}) {
    // One coordinate whose last bit is far below: no integers, the bound and then the chain.
    const StageShares s = shares<F>(exponent, false, std::ldexp(1.0, exponent - 90));
    EXPECT_GE(s.percent(PlanStage::bound), 99.8) << exponent;
  }
  // On the other side of 2^-968 the bound has its floor, and beyond 2^1000 none.
  EXPECT_EQ(shares<F>(-1000, false).percent(PlanStage::bound), 0);
  EXPECT_EQ(shares<F>(1020, false).percent(PlanStage::bound), 0);
}

TYPED_TEST(PlannedStageTest, NoBoundTellsZero) {
  using F = TypeParam;
  if (degree<F>() == 4) return;  // collinear points have no circle that a fourth is exactly on
  const StageShares s = shares<F>(0, true, 0x1p-90);
  EXPECT_EQ(s.percent(PlanStage::exact), 100);
}

TYPED_TEST(PlannedStageTest, IntegersOfTheLatticeTellZero) {
  using F = TypeParam;
  if (certify::planned::several_words<F> == certify::planned::two_words<F>) return;  // no chain: plans of two words
  // As words up to 51 bits, as doubles beyond, and the last lattice whose integers have four words.
  for (const int bits : {43, 51, 52, certify::planned::several_words<F>}) {
    const Kernel kernel(Lattice{-40, bits});
    StageShares shares;
    for (std::uint64_t i = 0; i < cases; ++i) {
      const auto p = coordinates_on<F>(kernel.lattice(), 3 * i + 1);  // exactly degenerate, or nearly
      kernel.with<F>([&](const auto& sign) {
        [&]<std::size_t... I>(std::index_sequence<I...>) {
          EXPECT_EQ(sign.recorded(shares, kernel.point(argument<F, I>(p))...), decide<F>(p))
              << described<F>(kernel.lattice(), p);
        }
        (std::make_index_sequence<arguments<F>.size()>{});
      });
    }
    EXPECT_GE(shares.percent(PlanStage::exact), 20) << bits;
  }
}

TYPED_TEST(PlannedStageTest, StepsBackToTheFilterWhereAPointIsFarOff) {
  using F = TypeParam;
  const StageShares s = shares<F>(0, false, 0x1p60);
  EXPECT_EQ(s.percent(PlanStage::bound), 0);
  EXPECT_GE(s.percent(PlanStage::filter), 99.8);
}

TEST(PlannedStageTest, OneThresholdIsThatOfFilterB) {
  for (int exponent = -1074; exponent <= 1023 - 60; ++exponent) {
    const Lattice lattice{exponent, 60};
    const LatticeIntake intake(lattice);
    const double reach = std::ldexp(1.0, exponent + 61);
    const auto compare = [&]<Formula F>(F) {
      const double planned = certify::planned::lattice_threshold<F>(intake);
      Largest<F> largest = per_axis<F>([&](std::size_t) { return std::max(reach, largest_floor<F>); });
      if (std::isinf(planned)) {
        EXPECT_GT(degree<F>() * (exponent + 61), 1000);
        return;
      }
      EXPECT_GE(planned, filter_constant<F>() * magnitude_over<F>(largest)) << F::name << ' ' << exponent;
      EXPECT_LE(planned, largest_threshold<F>(largest)) << F::name << ' ' << exponent;
    };
    compare(Orient2d{});
    compare(Orient3d{});
    compare(InCircle{});
    compare(InSphere{});
  }
}

}  // namespace
}  // namespace plumb
