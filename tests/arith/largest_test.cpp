#include "plumb/arith/largest.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "arith/samples.hpp"
#include "arith/watched.hpp"
#include "certify/sanitized.hpp"
#include "plumb/certify/detail/filter_stage.hpp"

namespace plumb {
namespace {

using samples::power_of_two;
using samples::rational;

// Filter B's law at every step: |plain value - exact| <= e * magnitude over the largest differences.
struct Within {
  mutable long steps = 0;

  template <class V, class L, class B>
  void operator()(const Beside<Beside<V, L>, B>& x, const mpq_class& exact) const {
    if constexpr (std::is_same_v<L, LargestMagnitude::Input>) return;  // it bounds differences, not what they are of
    const double value = x.a.a;
    const double magnitude = LargestMagnitude(x.a.b).magnitude;
    if (!(magnitude < samples::infinity) || !(magnitude_of(value) < samples::infinity)) return;
    ++steps;
    const mpq_class allowed =
        mpq_class(static_cast<unsigned long>(Bound(x.b).e)) * power_of_two(-85) * rational(magnitude);
    ASSERT_TRUE(abs(rational(value) - exact) <= allowed) << std::hexfloat << value << " with magnitude " << magnitude;
    ASSERT_LE(magnitude_of(value), magnitude);
  }
};

TEST(LargestMagnitudeTest, BoundsTheErrorOfEveryStep) {
  for_each_formula([]<Formula F>() {
    SCOPED_TRACE(F::name);
    for (const FamilyInfo& f : families) {
      SCOPED_TRACE(f.name);
      Within within;
      Entropy entropy(11, static_cast<std::uint64_t>(f.family));
      Coordinates<F> p{};
      for (int i = 0; i < battery::fitting(2'000) && !testing::Test::HasFatalFailure(); ++i) {
        fill_points(f.family, Degeneracy::coplanar, F::dimension, p, entropy);
        const Largest<F> largest = largest_differences<F>(p);
        evaluate<F>([&](std::size_t k) {
          using Pair = Beside<double, LargestMagnitude::Input>;
          return watched(Beside<Pair, Bound::Input>{{p[k], {largest[axis_of_input<F>(k)]}}, {}}, rational(p[k]),
                         &within);
        });
      }
      ASSERT_GT(within.steps, battery::fitting(2'000));
    }
  });
}

// Filtered's guards are allowed for: filter B has its floor instead.
TEST(LargestMagnitudeTest, ThresholdIsNeverBelowThatOfFilterA) {
  for_each_formula([]<Formula F>() {
    SCOPED_TRACE(F::name);
    Entropy entropy(12);
    Coordinates<F> p{};
    for (int i = 0; i < 20'000; ++i) {
      fill_points(any_family(entropy), Degeneracy::cospherical, F::dimension, p, entropy);
      const double value = value_of<F>(p);
      const Filtered a = evaluate<F>([&](std::size_t k) { return Filtered::Input{p[k]}; });
      if (!(a.magnitude < samples::infinity) || value != value) continue;
      const Largest<F> largest = largest_differences<F>(p);
      const double guards =
          filter_constant<F>() * static_cast<double>(certify::tape::program<F>().instructions.size()) * underflow_guard;
      ASSERT_GE(largest_threshold<F>(largest) + guards, filter_constant<F>() * a.magnitude * (1 - 0x1p-45));
      // The product form and the sum over the formula are the same bound.
      if (!(magnitude_over<F>(largest) < samples::infinity)) continue;  // the product form overflows later
      ASSERT_GE(largest_threshold<F>(largest), filter_constant<F>() * magnitude_over<F>(largest));
      for (const double l : largest) ASSERT_GE(l, largest_floor<F>);
    }
  });
}

TEST(LargestMagnitudeTest, NothingIsBeyondAnOverflow) {
  // Differences in x of 2^1020 and in z of 2^-1074: an intermediate product overflows, the threshold does not.
  const Coordinates<predicates::Orient3d> p{0x1p1020,  0x1p1020, 0, 0x1p1019, -0x1p1020, 0x1p-1074,
                                            -0x1p1020, 3,        0, 0,        0,         0};
  EXPECT_EQ(largest_filter<predicates::Orient3d>(p), 0);
  EXPECT_EQ(magnitude_filter<predicates::Orient3d>(p), 0);
  for (const double bad : {samples::infinity, -samples::infinity, std::numeric_limits<double>::quiet_NaN()}) {
    for_each_formula([&]<Formula F>() {
      for (std::size_t i = 0; i < arity<F>; ++i) {
        Coordinates<F> q{};
        for (std::size_t k = 0; k < q.size(); ++k) q[k] = static_cast<double>(k * k + 1);
        q[i] = bad;
        EXPECT_EQ(magnitude_filter<F>(q), 0) << F::name << ' ' << i;
        EXPECT_EQ(largest_filter<F>(q), 0) << F::name << ' ' << i;
      }
    });
  }
}

// The floor's power in the formula's degree is a normal number; the next lower power of two would do no longer.
TEST(LargestMagnitudeTest, FloorIsTheLeast) {
  for_each_formula([]<Formula F>() {
    const double power = std::pow(largest_floor<F>, degree<F>());
    EXPECT_GE(power, underflow_guard) << F::name;
    EXPECT_LT(std::pow(largest_floor<F> / 2, degree<F>()), underflow_guard) << F::name;
  });
}

using Plane = AxisDegrees<2>;
using Space = AxisDegrees<3>;
static_assert(axis_degrees<predicates::Orient2d>.equal_terms &&
              axis_degrees<predicates::Orient2d>.degree == std::array{1, 1});
static_assert(axis_degrees<predicates::Orient3d>.equal_terms &&
              axis_degrees<predicates::Orient3d>.degree == std::array{1, 1, 1});
static_assert(!axis_degrees<predicates::InCircle>.equal_terms && !axis_degrees<predicates::InSphere>.equal_terms);
static_assert(!(Plane(Plane::Input{0}) + Plane(Plane::Input{1})).equal_terms);
static_assert((Space(Space::Input{0}) * Space(Space::Input{2})).degree == std::array{1, 0, 1});

}  // namespace
}  // namespace plumb
