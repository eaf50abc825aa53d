// May a formula multiply by whole numbers and take opposites?  Is what it then is the polynomial as written, in every
// stage, and is its bound derived?
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/every_stage.hpp"
#include "certify/nearest_value.hpp"
#include "certify/rounded.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/certify/bound_report.hpp"
#include "plumb/certify/kernel.hpp"
#include "plumb/certify/perturbed.hpp"
#include "plumb/degenerate.hpp"

namespace plumb {
namespace {

struct Discriminant {
  static constexpr std::string_view name = "discriminant";
  static constexpr int points = 3, dimension = 1;
  template <class T>
  constexpr auto operator()(const std::array<T, 3>& p) const {
    return p[1] * p[1] - 4.0 * p[0] * p[2];
  }
};

// The discriminant of a x^3 + b x^2 + c x + d.
struct CubicDiscriminant {
  static constexpr std::string_view name = "cubic_discriminant";
  static constexpr int points = 4, dimension = 1;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    const auto &a = p[0], &b = p[1], &c = p[2], &d = p[3];
    return 18 * a * b * c * d - 4 * b * b * b * d + b * b * c * c - 4 * a * c * c * c - 27 * a * a * d * d;
  }
};

// An opposite at the root, of a sum and of a product.
struct MinusSum {
  static constexpr std::string_view name = "minus_sum";
  static constexpr int points = 2, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    return -((p[0] - p[2]) * p[1] + p[3] * -p[3]);
  }
};
struct MinusProduct {
  static constexpr std::string_view name = "minus_product";
  static constexpr int points = 2, dimension = 1;
  template <class T>
  constexpr auto operator()(const std::array<T, 2>& p) const {
    return -5 * p[0] * p[1];
  }
};

mpq_class value(Discriminant, const std::vector<mpq_class>& p) { return p[1] * p[1] - 4 * p[0] * p[2]; }
mpq_class value(CubicDiscriminant, const std::vector<mpq_class>& p) {
  const mpq_class &a = p[0], &b = p[1], &c = p[2], &d = p[3];
  return 18 * a * b * c * d - 4 * b * b * b * d + b * b * c * c - 4 * a * c * c * c - 27 * a * a * d * d;
}
mpq_class value(MinusSum, const std::vector<mpq_class>& p) { return p[3] * p[3] - (p[0] - p[2]) * p[1]; }
mpq_class value(MinusProduct, const std::vector<mpq_class>& p) { return -5 * p[0] * p[1]; }

template <Formula F>
Sign truth(const Coordinates<F>& p) {
  std::vector<mpq_class> exact;
  for (const double x : p) exact.emplace_back(x);
  return sign_of_number(sgn(value(F{}, exact)));
}

template <class F>
class ConstantsTest : public testing::Test {
 protected:
  // Small integers meet the zeros; then coordinates of every size, and next to zeros.
  static Coordinates<F> coordinates(std::uint64_t seed) {
    Entropy e(seed);
    Coordinates<F> p{};
    for (double& x : p) x = seed % 3 == 0 ? extreme_coordinate(e) : static_cast<double>(e.within(6));
    if (seed % 3 == 1) p[0] = std::nextafter(p[0], 9e9);
    return p;
  }
};
using Formulas = testing::Types<Discriminant, CubicDiscriminant, MinusSum, MinusProduct>;
TYPED_TEST_SUITE(ConstantsTest, Formulas);

TYPED_TEST(ConstantsTest, EveryStageAgreesWithThePolynomialAsWritten) {
  using F = TypeParam;
  std::array<int, 3> signs{};
  StageCounts counts;
  for (std::uint64_t seed = 0; seed < 30'000; ++seed) {
    const Coordinates<F> p = this->coordinates(seed);
    const Sign exact = truth<F>(p);
    ++signs[static_cast<std::size_t>(static_cast<int>(exact) + 1)];
    expect_of_every_stage<F>(p, exact, counts);
    ASSERT_FALSE(this->HasFailure()) << seed;
  }
  for (const int n : signs) EXPECT_GT(n, 200);
  EXPECT_GT(counts.of(Stage::filter), 5'000u);
  EXPECT_GT(counts.of(Stage::integer), 200u);
}

TYPED_TEST(ConstantsTest, PlansAreExactAtTheirWidest) {
  using F = TypeParam;
  for (const int bits : {certify::planned::plain_double<F>, certify::planned::one_word_factors<F>,
                         certify::planned::modulo_word<F>, certify::planned::two_words<F>, 60}) {
    if (bits < 2) continue;
    Kernel kernel(plan(Lattice{0, bits}));
    Entropy e(static_cast<std::uint64_t>(bits));
    for (int i = 0; i < 2'000; ++i) {
      const std::int64_t most = (std::int64_t{1} << std::min(bits, 53)) - 1;
      Coordinates<F> p{};
      for (double& x : p) x = static_cast<double>(i % 2 == 0 ? e.within(most) : e.within(3));
      const Sign said = std::apply([&](auto... x) { return kernel.template sign<F>(x...); }, p);
      ASSERT_EQ(said, truth<F>(p)) << bits << ' ' << i;
    }
  }
}

TYPED_TEST(ConstantsTest, PerturbedSignsFollowTheExactOnes) {
  using F = TypeParam;
  Indices<F> indices{};
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = 7 * i + 3;
  for (std::uint64_t seed = 0; seed < 3'000; ++seed) {
    const Coordinates<F> p = this->coordinates(seed);
    const Sign exact = truth<F>(p), moved = decide<F>(perturbed, p, indices);
    ASSERT_NE(moved, Sign::zero);
    if (exact != Sign::zero) {
      ASSERT_EQ(moved, exact);
    }
  }
}

// One coordinate moved by the largest infinitesimal: b^2 - 4 a c at 0 with c moved has the sign of -4 a.
TEST(ConstantsTest, InfinitesimalsCarryConstants) {
  const Indices<Discriminant> first_c{2, 1, 0};
  EXPECT_EQ(decide<Discriminant>(perturbed, {1, 2, 1}, first_c), Sign::negative);
  EXPECT_EQ(decide<Discriminant>(perturbed, {-1, 2, -1}, first_c), Sign::positive);
}

TEST(ConstantsTest, EveryConstantIsThatManyTimes) {
  const auto product = [](auto constant) {
    certify::tape::Tape<128> tape;
    tape.arity = 2;
    const certify::tape::Recorded<128> x{&tape, 0}, y{&tape, 1};
    const certify::tape::Recorded<128> result = constant * x * y;
    const std::uint16_t last = result.result();
    tape.size = last - 1u;
    EXPECT_EQ(tape.misuse, certify::tape::Misuse::none) << constant;
    return nearest_value(certify::tape::Program{2, std::span(tape.instructions).first(tape.size)},
                         std::array{1.0, 3.0});
  };
  for (int n = 1; n < 3'000; ++n) {
    ASSERT_EQ(product(n), 3.0 * n);
    ASSERT_EQ(product(-static_cast<double>(n)), -3.0 * n);
  }
  for (const std::int64_t n : {0x7fffffffll, -0x7fffffffll, 0x40000000ll, 0x55555555ll, -0x2aaaaaaall})
    ASSERT_EQ(product(n), 3.0 * static_cast<double>(n));
}

TEST(ConstantsTest, OtherConstantsAreNotedNotTaken) {
  const auto misuse = [](auto constant) {
    certify::tape::Tape<128> tape;
    tape.arity = 1;
    static_cast<void>(constant * certify::tape::Recorded<128>{&tape, 0});
    static_cast<void>(certify::tape::Recorded<128>{&tape, 0} * constant);
    return tape.misuse;
  };
  EXPECT_EQ(misuse(2147483647u), certify::tape::Misuse::none);
  for (const double x : {0.0, 0.5, 2147483648.0, 1e300, -1.5, std::numeric_limits<double>::infinity(),
                         std::numeric_limits<double>::quiet_NaN(), 0x1.0000000000001p4})
    EXPECT_EQ(misuse(x), certify::tape::Misuse::broken_constant) << x;
  EXPECT_EQ(misuse(0), certify::tape::Misuse::broken_constant);
  EXPECT_EQ(misuse(1ll << 40), certify::tape::Misuse::broken_constant);
}

// A lambda's result of one rounding, and its report.
TEST(ConstantsTest, LambdasHaveThem) {
  constexpr auto discriminant = [](auto a, auto b, auto c) { return b * b - 4 * a * c; };
  EXPECT_EQ(sign_of(discriminant, 0.1, 0.2, 0.1), Sign::zero);
  EXPECT_EQ(sign_of(discriminant, 0.1, 0.2, 0x1.999999999999bp-4), Sign::negative);
  EXPECT_EQ(rounded_value(Rounding::nearest, discriminant, 0.1, 0.3, 0.2),
            (Rational(0.3) * Rational(0.3) - Rational(4) * Rational(0.1) * Rational(0.2)).rounded());
  const BoundReport report = bound_report(discriminant, 1.0, 1.0, 1.0);
  EXPECT_EQ(report.operations, 5u);  // two doublings
  EXPECT_EQ(report.terms, 5);
  EXPECT_EQ(report.degree, 2);
  EXPECT_LT(report.constant, 0x1.0000001p-53);  // the products' roundings alone
}

}  // namespace
}  // namespace plumb
