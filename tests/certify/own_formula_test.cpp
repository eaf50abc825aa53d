// What a user states in the same way gets the same stages: formulas of shapes that the manifest does not have, every
// stage held against rationals.
#include <gtest/gtest.h>

#include <limits>

#include "certify/every_stage.hpp"
#include "certify/sanitized.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/degenerate.hpp"
#include "plumb/predicates.hpp"

namespace plumb {
namespace {

// Sums and products of coordinates as given, beside differences.
struct Mixed {
  static constexpr std::string_view name = "mixed";
  static constexpr int points = 2, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    return (p[0] + p[1]) * (p[2] + p[3]) * p[0] - p[0] * p[2] * p[3] - p[1] * (p[2] - p[3]) * p[0];
  }
};

// Computes something more after its result.
struct Leftover {
  static constexpr std::string_view name = "leftover";
  static constexpr int points = 2, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    const auto result = p[0] * p[3] - p[1] * p[2];
    [[maybe_unused]] const auto more = p[0] * p[1] + p[2] * p[2];
    return result;
  }
};

// The determinant of four vectors in four dimensions: every term has the same degree in each axis.
struct FourVectors {
  static constexpr std::string_view name = "four_vectors";
  static constexpr int points = 4, dimension = 4;
  template <class T>
  constexpr auto operator()(const std::array<T, 16>& p) const {
    using predicates::det3;
    return p[0] * det3(p[5], p[6], p[7], p[9], p[10], p[11], p[13], p[14], p[15]) -
           p[1] * det3(p[4], p[6], p[7], p[8], p[10], p[11], p[12], p[14], p[15]) +
           p[2] * det3(p[4], p[5], p[7], p[8], p[9], p[11], p[12], p[13], p[15]) -
           p[3] * det3(p[4], p[5], p[6], p[8], p[9], p[10], p[12], p[13], p[14]);
  }
};

// A product at the root, and of differences across axes.
struct AcrossAxes {
  static constexpr std::string_view name = "across_axes";
  static constexpr int points = 2, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    return (p[0] - p[1]) * (p[2] * p[3] - p[0] * (p[1] + p[2]));
  }
};

// More operations than some compilers nest, every term of the same degree; zero, however long it takes.
struct Long {
  static constexpr std::string_view name = "long";
  static constexpr int points = 3, dimension = 1;
  template <class T>
  constexpr auto operator()(const std::array<T, 3>& p) const {
    const auto a = p[0] - p[2], b = p[1] - p[2];
    const auto none = [&](const auto& x) { return x * a * b - b * x * a + a * a * x - x * a * a; };
    const auto few = [&](const auto& x) { return none(x) + none(x + a) - none(x - b); };
    const auto some = [&](const auto& x) { return few(x) - few(x + b) + few(x - a); };
    return some(a) + some(b) + some(a + b);
  }
};
static_assert(certify::tape::program<Long>().instructions.size() > 256);

template <class F>
class OwnFormulaTest : public testing::Test {};
using OwnFormulas = testing::Types<Mixed, Leftover, FourVectors, AcrossAxes, Long>;
TYPED_TEST_SUITE(OwnFormulaTest, OwnFormulas);

TYPED_TEST(OwnFormulaTest, EveryStageAgreesWithRationals) {
  using F = TypeParam;
  const auto far = [](Entropy& e) { return extreme_coordinate(e); };
  const auto near = [](Entropy& e) { return static_cast<double>(e.within(3)); };
  int zeros = 0;
  for (std::uint64_t seed = 0; seed < battery::fitting(20'000u); ++seed) {
    Entropy e(seed);
    Coordinates<F> p{};
    for (double& x : p) x = seed % 2 == 0 ? far(e) : near(e);
    const Sign exact = evaluate<F>([&](std::size_t i) { return big_rational(p[i]); }).sign();
    zeros += exact == Sign::zero;
    expect_of_every_stage<F>(p, exact);
    ASSERT_FALSE(this->HasFailure()) << seed;
  }
  EXPECT_GT(zeros, battery::fitting(100));
}

TEST(OwnFormulaTest, NamesTheBadCoordinateOfAnyDimension) {
  Coordinates<FourVectors> p{};
  p[7] = std::numeric_limits<double>::infinity();
  try {
    decide<FourVectors>(p);
    FAIL() << "took an infinity";
  } catch (const NonFinite& e) {
    EXPECT_STREQ(e.what(), "four_vectors: coordinate 7 is inf, not a real number; give a finite double");
  }
}

}  // namespace
}  // namespace plumb
