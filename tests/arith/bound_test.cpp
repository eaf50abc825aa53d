#include "plumb/arith/bound.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "arith/samples.hpp"
#include "arith/watched.hpp"
#include "certify/sanitized.hpp"
#include "plumb/arith/filtered.hpp"
#include "plumb/arith/largest.hpp"

namespace plumb {
namespace {

using samples::power_of_two;
using samples::rational;

// The rule of docs/proof.md in rationals, without the roundings up.
struct ExactBound {
  struct Input {};
  mpq_class e;
  ExactBound(Input) : e(0) {}  // NOLINT: as in Bound
  explicit ExactBound(mpq_class x) : e(std::move(x)) {}

  static mpq_class eps() { return power_of_two(-53); }
  friend ExactBound operator-(Input, Input) { return ExactBound(eps()); }
  friend ExactBound operator+(Input, Input) { return ExactBound(eps()); }
  friend ExactBound operator+(const ExactBound& a, const ExactBound& b) {
    return ExactBound(mpq_class(std::max(a.e, b.e) * (1 + eps()) + eps()));
  }
  friend ExactBound operator-(const ExactBound& a, const ExactBound& b) { return a + b; }
  friend ExactBound operator*(const ExactBound& a, const ExactBound& b) {
    const mpq_class s = a.e + b.e + a.e * b.e;
    return ExactBound(mpq_class((s * (1 + eps()) + eps()) * (1 + eps())));
  }
  friend ExactBound twice(const ExactBound& a) { return a; }
};

TEST(BoundTest, IsTheRuleRoundedUpByAFewUnits) {
  for_each_formula([]<Formula F>() {
    const Bound bound(value_of<F>(std::array<Bound::Input, arity<F>>{}));
    const ExactBound exact(value_of<F>(std::array<ExactBound::Input, arity<F>>{}));
    const mpq_class units = exact.e * power_of_two(85);
    EXPECT_TRUE(mpq_class(static_cast<unsigned long>(bound.e)) >= units) << F::name;
    EXPECT_TRUE(mpq_class(static_cast<unsigned long>(bound.e)) <=
                units + 6 * static_cast<int>(certify::tape::program<F>().instructions.size()))
        << F::name;
    EXPECT_LE(bound.root, bound.e);
  });
}

// Holds value and magnitude against the bound and the exact value, and keeps the worst.
struct Worst {
  mutable double ratio = 0;  // of the error to what the bound allows
  mutable long steps = 0;

  template <class V, class B>
  void operator()(const Beside<V, B>& x, const mpq_class& exact) const {
    const Filtered f(x.a);
    const Bound b(x.b);
    ASSERT_FALSE(f.magnitude < magnitude_of(f.value)) << std::hexfloat << f.value << ' ' << f.magnitude;
    if (!(f.magnitude < samples::infinity) || f.value != f.value) return;  // nothing exceeds it: no promise is made
    ++steps;
    const mpq_class error = abs(rational(f.value) - exact);
    const mpq_class allowed = mpq_class(static_cast<unsigned long>(b.e)) * power_of_two(-85) * rational(f.magnitude);
    ASSERT_TRUE(error <= allowed) << std::hexfloat << f.value << " with magnitude " << f.magnitude;
    if (allowed > 0) ratio = std::max(ratio, mpq_class(error / allowed).get_d());
  }
};

template <Formula F>
Worst measure(Family family, int cases) {
  Worst worst;
  Entropy entropy(7, static_cast<std::uint64_t>(family));
  Coordinates<F> p{};
  for (int i = 0; i < cases && !testing::Test::HasFatalFailure(); ++i) {
    fill_points(family, F::dimension == 2 ? Degeneracy::cocircular : Degeneracy::cospherical, F::dimension, p, entropy);
    evaluate<F>([&](std::size_t k) {
      return watched(Beside<Filtered::Input, Bound::Input>{{p[k]}, {}}, rational(p[k]), &worst);
    });
  }
  return worst;
}

TEST(BoundTest, NoStepOfAnyFormulaErrsByMore) {
  for_each_formula([]<Formula F>() {
    SCOPED_TRACE(F::name);
    for (const FamilyInfo& f : families) {
      SCOPED_TRACE(f.name);
      const Worst worst = measure<F>(f.family, battery::fitting(400));
      ASSERT_GT(worst.steps, battery::fitting(400));  // overflow is the exception, even among extreme exponents
    }
  });
}

// A bound many times too large would pass the tests above and cost speed.
TEST(BoundTest, IsNotWastedOnTheClassicFormulas) {
  EXPECT_GT(measure<predicates::Orient2d>(Family::uniform, 4'000).ratio, 0.5);
  EXPECT_GT(measure<predicates::Orient3d>(Family::uniform, 4'000).ratio, 0.25);
  EXPECT_GT(measure<predicates::InCircle>(Family::uniform, 4'000).ratio, 0.25);
  EXPECT_GT(measure<predicates::InSphere>(Family::uniform, 4'000).ratio, 0.25);
}

// Subnormal products: the guard alone pays.
TEST(BoundTest, TheGuardPaysForUnderflow) {
  Worst worst;
  Entropy entropy(3);
  Coordinates<predicates::InCircle> p{};
  for (int i = 0; i < battery::fitting(5'000); ++i) {
    for (double& x : p) x = std::ldexp(signed_unit_coordinate(entropy), -265 - static_cast<int>(entropy.below(8)));
    evaluate<predicates::InCircle>([&](std::size_t k) {
      return watched(Beside<Filtered::Input, Bound::Input>{{p[k]}, {}}, rational(p[k]), &worst);
    });
    ASSERT_FALSE(HasFatalFailure());
  }
}

TEST(BoundTest, RefusesFormulasBeyondItsUnits) {
  Bound b = Bound::Input{} - Bound::Input{};
  EXPECT_THROW(
      {
        for (int i = 0; i < 20; ++i) b = b * b;
      },
      std::overflow_error);
}

// 3, 7, 10 and 15 roundings of 2^-53, and a little for their products.
template <Formula F>
constexpr bool has_roundings(double n) {
  return filter_constant<F>() > n * 0x1p-53 && filter_constant<F>() < n * (1 + 0x1p-30) * 0x1p-53;
}
static_assert(has_roundings<predicates::Orient2d>(3) && has_roundings<predicates::Orient3d>(7));
static_assert(has_roundings<predicates::InCircle>(10) && has_roundings<predicates::InSphere>(15));

// Powers of two cost nothing, other constants a rounding for each binary one but the first.
template <int N>
struct Times {
  static constexpr std::string_view name = "times";
  static constexpr int points = 4, dimension = 1;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    return N * p[0] * p[1] - p[2] * p[3];
  }
};
template <int N>
constexpr bool costs(double roundings) {
  const double n = filter_constant<Times<N>>() * 0x1p53;
  return n > roundings && n < roundings + 0x1p-24;
}
static_assert(costs<1>(1) && costs<2>(1) && costs<0x40000000>(1) && costs<3>(2) && costs<10>(2) && costs<7>(3));

}  // namespace
}  // namespace plumb
