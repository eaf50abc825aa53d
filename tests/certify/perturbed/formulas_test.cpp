// Perturbation is an option of every formula, not of the classic four alone: shapes, degrees and sizes that they do not
// have, against the definition.
#include <gtest/gtest.h>

#include <cmath>

#include "certify/expanded_oracle.hpp"
#include "plumb/certify/perturbed.hpp"
#include "plumb/degenerate.hpp"

namespace plumb {
namespace {

// Swapping points neither flips nor keeps the sign; a square of each coordinate.
struct DiametralCircle {
  static constexpr std::string_view name = "diametral_circle";
  static constexpr int points = 3, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return (p[0] - p[4]) * (p[4] - p[2]) + (p[1] - p[5]) * (p[5] - p[3]);
  }
};

// Cubes, and coordinates of one point multiplied with one another.
struct Cubic {
  static constexpr std::string_view name = "cubic";
  static constexpr int points = 2, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    const auto a = p[0] - p[2], b = p[1] - p[3];
    return a * a * b * p[1] - b * b * b * a + p[0] * p[1] * p[2] * p[3];
  }
};

// Arguments of different kinds, and terms of different degrees.
struct AboveParaboloid {
  static constexpr std::string_view name = "above_paraboloid";
  static constexpr std::array arguments{2, 1};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 3>& p) const {
    return (p[2] - p[0] * p[0] - p[1] * p[1]) * (p[2] - p[0]);
  }
};

// Has a square in one coordinate only, and does not depend on the last.
struct Partly {
  static constexpr std::string_view name = "partly";
  static constexpr int points = 3, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    const auto none = p[5] - p[5];
    return p[0] * p[1] * p[2] * p[3] + p[2] * p[2] * (p[0] * p[4] - p[1] * p[3]) + none * p[0] * p[0] * p[1];
  }
};

template <class F>
class PerturbedFormulaTest : public testing::Test {};
using Formulas = testing::Types<DiametralCircle, Cubic, AboveParaboloid, Partly>;
TYPED_TEST_SUITE(PerturbedFormulaTest, Formulas);

TYPED_TEST(PerturbedFormulaTest, IsTheSignOfTheLargestTerm) {
  using F = TypeParam;
  int zeros = 0;
  for (std::uint64_t number = 0; number < 6'000; ++number) {
    Entropy e(31, number);
    Coordinates<F> p{};
    Indices<F> indices{};
    const bool far = number % 8 == 0;  // beyond every fixed width
    for (double& x : p)
      x = static_cast<double>(e.within(1)) *
          (far ? extreme_coordinate(e) : std::ldexp(1, static_cast<int>(number % 5) - 2));
    for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = (e.below(100) << 8) + i;
    zeros += decide<F>(p) == Sign::zero;
    ASSERT_EQ(decide<F>(perturbed, p, indices), (oracle::expanded_sign<F>(p, indices))) << number;
  }
  EXPECT_GT(zeros, 500);
}

// Not zero, so that the largest term is the value itself: integers of every width, up to where they are allocated.
TEST(PerturbedFormulaTest, ExpandsOverCoordinatesOfAnyWidth) {
  using F = predicates::InCircle;
  std::array<std::uint16_t, arity<F>> order{};
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint16_t>(i);
  for (int width = 4; width < 400; ++width) {
    for (std::uint64_t number = 0; number < 20; ++number) {
      Entropy e(static_cast<std::uint64_t>(width), number);
      Coordinates<F> p{};
      for (double& x : p) {
        const int bits = std::min(width, 53);
        x = std::ldexp(static_cast<double>(e.bits(bits)), e.coin() ? width - bits : 0) * (e.coin() ? 1 : -1);
      }
      const Sign exact = decide<F>(p);
      if (exact == Sign::zero) continue;
      ASSERT_EQ(certify::perturbation::expanded_sign(certify::tape::program<F>(), true, p, order), exact)
          << width << " " << number;
    }
  }
}

// Sixty-six coordinates: more than the bits of a word, and than one has letters for points.
struct LongChain {
  static constexpr std::string_view name = "long_chain";
  static constexpr int points = 33, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 66>& p) const {
    return [&]<std::size_t... I>(std::index_sequence<I...>) {
      return (((p[2 * I] - p[2 * I + 2]) * (p[2 * I + 1] - p[2 * I + 3])) + ...);
    }
    (std::make_index_sequence<32>{});
  }
};

TEST(PerturbedFormulaTest, TakesFormulasOfAnyLength) {
  Coordinates<LongChain> p{};
  Indices<LongChain> indices{};
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = i;
  // The largest term is e0 e1 of the first point, whose sign nothing but the formula decides.
  EXPECT_EQ(decide<LongChain>(perturbed, p, indices), Sign::positive);
  // The last point moves most: its neighbor's x is to its right, so that moving up y counts against it.
  std::ranges::reverse(indices);
  p[62] = 1;
  EXPECT_EQ(decide<LongChain>(perturbed, p, indices), Sign::negative);
  indices[32] = indices[31];
  try {
    decide<LongChain>(perturbed, p, indices);
    FAIL() << "took two of one index";
  } catch (const RepeatedIndex& e) {
    EXPECT_STREQ(e.what(),
                 "long_chain: argument 31 and argument 32 both have the index 1; give each point an index of its own");
  }
}

// The same polynomial twice, one minus the other.
struct Nothing {
  static constexpr std::string_view name = "nothing";
  static constexpr int points = 2, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    return (p[0] + p[1]) * (p[2] - p[3]) - (p[0] * p[2] - p[0] * p[3]) - (p[1] * p[2] - p[1] * p[3]);
  }
};

TEST(PerturbedFormulaTest, ZeroEverywhereIsAnError) {
  try {
    decide<Nothing>(perturbed, {1, 2, 3, 4}, {0, 1});
    FAIL() << "perturbed nothing";
  } catch (const Error& e) {
    EXPECT_STREQ(e.what(), "nothing: is zero wherever it is evaluated; no perturbation changes that");
  }
}

}  // namespace
}  // namespace plumb
