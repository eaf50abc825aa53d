// The laws that include/plumb/certify/perturbed.hpp numbers, on the classic four, against the definition.
#include "plumb/certify/perturbed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "certify/battery.hpp"
#include "certify/expanded_oracle.hpp"

namespace plumb {
namespace {

/// Of so many cases, how many this build takes.
std::uint64_t affordable(std::uint64_t count) {
#if defined(PLUMB_LONG_TESTS)
  return 50 * count;
#else
  return battery::fitting(count);
#endif
}

template <Formula F>
struct Case {
  Coordinates<F> p;
  Indices<F> indices;
  std::uint64_t number;
};

template <Formula F>
std::string told(const Case<F>& c) {
  std::string text = to_string(CaseLine{std::string(F::name), {c.p.begin(), c.p.end()}, Unsure{Sign::zero}});
  text.append(" # indices");
  for (const std::uint64_t i : c.indices) text.append(" ").append(std::to_string(i));
  return text.append(", case ").append(std::to_string(c.number));
}

/// Distinct indices, small or of 64 bits.
template <Formula F>
Indices<F> any_indices(Entropy& e) {
  Indices<F> indices{};
  for (std::size_t i = 0; i < indices.size(); ++i) {
    do {
      indices[i] = e.coin() ? e.below(16) : ~e.below(1u << 20);
    } while (std::count(indices.begin(), indices.begin() + static_cast<std::ptrdiff_t>(i), indices[i]) != 0);
  }
  return indices;
}

/// Every kind of degeneracy: the families, tiny grids, and all points in one or two places.
template <Formula F>
Case<F> any_case(std::uint64_t number) {
  Entropy e(static_cast<std::uint64_t>(F::points * 10 + F::dimension), number);
  Case<F> c{{}, any_indices<F>(e), number};
  constexpr auto axes = static_cast<std::size_t>(F::dimension);
  switch (number % 4) {
    case 0:
      for (double& x : c.p) x = static_cast<double>(e.below(number % 8 < 4 ? 2 : 3));
      break;
    case 1: {
      fill_points(any_family(e), degeneracies[e.below(degeneracies.size())], F::dimension, c.p, e);
      for (std::size_t i = axes; i < c.p.size(); i += axes) {
        const std::size_t other = axes * e.below(2);
        if (e.below(4) != 0) std::copy_n(&c.p[other], axes, &c.p[i]);
      }
      break;
    }
    default:
      fill_points(any_family(e), degeneracies[e.below(degeneracies.size())], F::dimension, c.p, e);
  }
  return c;
}

/// Visits this many cases that are exactly zero, or as many of them as are affordable.
template <Formula F, class Visit>
void for_each_zero(std::uint64_t count, const Visit& visit) {
  for (std::uint64_t number = 0, seen = 0; seen < affordable(count) && !testing::Test::HasFatalFailure(); ++number) {
    const Case<F> c = any_case<F>(number);
    if (decide<F>(c.p) != Sign::zero) continue;
    ++seen;
    visit(c);
  }
}

template <class F>
class PerturbedTest : public testing::Test {};
using Classics = testing::Types<predicates::Orient2d, predicates::Orient3d, predicates::InCircle, predicates::InSphere>;
TYPED_TEST_SUITE(PerturbedTest, Classics);

TYPED_TEST(PerturbedTest, IsTheSignOfTheLargestTerm) {
  using F = TypeParam;
  const std::uint64_t count = arity<F> == 15 ? 200 : arity<F> == 12 ? 1000 : 2000;
  for_each_zero<F>(count, [](const Case<F>& c) {
    ASSERT_EQ(decide<F>(perturbed, c.p, c.indices), (oracle::expanded_sign<F>(c.p, c.indices))) << told(c);
  });
}

TYPED_TEST(PerturbedTest, MovesAndExpansionAgree) {
  using F = TypeParam;
  int positive = 0, all = 0;
  for_each_zero<F>(2'000, [&](const Case<F>& c) {
    const auto rank = oracle::ranks<F>(c.indices);
    std::array<std::uint16_t, arity<F>> order{};
    for (std::size_t i = 0; i < rank.size(); ++i) order[rank[i]] = static_cast<std::uint16_t>(i);
    const Sign s = decide<F>(perturbed, c.p, c.indices);
    positive += s == Sign::positive;
    ++all;
    ASSERT_NE(s, Sign::zero) << told(c);
    ASSERT_EQ(certify::perturbation::expanded_sign(certify::tape::program<F>(), true, c.p, order), s) << told(c);
  });
  EXPECT_GT(positive, all * 2 / 5);
  EXPECT_LT(positive, all * 3 / 5);
}

TYPED_TEST(PerturbedTest, EveryPermutationGivesThePermutedSign) {
  using F = TypeParam;
  constexpr auto axes = static_cast<std::size_t>(F::dimension);
  for_each_zero<F>(200, [](const Case<F>& c) {
    std::array<std::size_t, static_cast<std::size_t>(F::points)> order{};
    std::iota(order.begin(), order.end(), std::size_t{0});
    const Sign first = decide<F>(perturbed, c.p, c.indices);
    do {
      Case<F> moved = c;
      Sign parity = Sign::positive;
      for (std::size_t i = 0; i < order.size(); ++i) {
        std::copy_n(&c.p[axes * order[i]], axes, &moved.p[axes * i]);
        moved.indices[i] = c.indices[order[i]];
        for (std::size_t k = i + 1; k < order.size(); ++k) parity = order[i] > order[k] ? -parity : parity;
      }
      ASSERT_EQ(decide<F>(perturbed, moved.p, moved.indices), parity * first) << told(moved);
    } while (std::ranges::next_permutation(order).found);
  });
}

TYPED_TEST(PerturbedTest, OnlyTheOrderOfTheIndicesMatters) {
  using F = TypeParam;
  for_each_zero<F>(500, [](const Case<F>& c) {
    Indices<F> ranks{}, spread{};
    for (std::size_t i = 0; i < ranks.size(); ++i) {
      ranks[i] = static_cast<std::uint64_t>(
          std::ranges::count_if(c.indices, [&](std::uint64_t other) { return other < c.indices[i]; }));
      spread[i] = ~std::uint64_t{0} - 1000 * (ranks.size() - ranks[i]);
    }
    const Sign s = decide<F>(perturbed, c.p, c.indices);
    ASSERT_EQ(decide<F>(perturbed, c.p, ranks), s) << told(c);
    ASSERT_EQ(decide<F>(perturbed, c.p, spread), s) << told(c);
  });
}

TYPED_TEST(PerturbedTest, ScalesByPowersOfTwo) {
  using F = TypeParam;
  for_each_zero<F>(500, [](const Case<F>& c) {
    for (const double by : {0x1p-30, 0x1p30}) {
      Case<F> scaled = c;
      for (double& x : scaled.p) x *= by;
      const auto exact = [&](std::size_t i) { return std::isfinite(scaled.p[i]) && scaled.p[i] / by == c.p[i]; };
      bool all = true;
      for (std::size_t i = 0; i < arity<F>; ++i) all &= exact(i);
      if (all) {
        ASSERT_EQ(decide<F>(perturbed, scaled.p, c.indices), decide<F>(perturbed, c.p, c.indices)) << told(c);
      }
    }
  });
}

TYPED_TEST(PerturbedTest, LeavesOtherSignsAsTheyAre) {
  using F = TypeParam;
  int others = 0;
  for (std::uint64_t number = 0; number < 2'000; ++number) {
    const Case<F> c = any_case<F>(number);
    const Sign exact = decide<F>(c.p);
    if (exact == Sign::zero) continue;
    ++others;
    StageCounts stages;
    ASSERT_EQ(decide<F>(perturbed, c.p, c.indices, stages), exact) << told(c);
    ASSERT_EQ(stages.total(), 1u);
  }
  EXPECT_GT(others, 200);
}

TYPED_TEST(PerturbedTest, EqualIndicesAreNamed) {
  using F = TypeParam;
  constexpr std::size_t n = Indices<F>{}.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = i + 1; k < n; ++k) {
      Indices<F> indices{};
      for (std::size_t a = 0; a < n; ++a) indices[a] = 10 * (n - a);
      indices[i] = indices[k] = 15;
      std::ostringstream said;  // GCC 12 sees sums of strings read too far where it inlines them all
      said << F::name << ": " << static_cast<char>('a' + i) << " and " << static_cast<char>('a' + k)
           << " both have the index 15; give each point an index of its own";
      const std::string text = said.str();
      try {
        decide<F>(perturbed, Coordinates<F>{}, indices);
        FAIL() << "took " << text;
      } catch (const RepeatedIndex& e) {
        EXPECT_EQ(e.what(), text);
      }
    }
  }
}

TYPED_TEST(PerturbedTest, RefusesWhatIsNoNumber) {
  using F = TypeParam;
  Coordinates<F> p{};
  p[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(decide<F>(perturbed, p, Indices<F>{}), NonFinite);
}

// What a reader can check by eye: the first index moves most, to the right.
TEST(PerturbedTest, MovesTheLowestIndexToTheRight) {
  const Point2 low{0, 0}, middle{0, 1}, high{0, 2};
  EXPECT_EQ(orient2d(perturbed, {low, 0}, {middle, 1}, {high, 2}), Sign::negative);
  EXPECT_EQ(orient2d(perturbed, {low, 1}, {middle, 0}, {high, 2}), Sign::positive);
  EXPECT_EQ(orient2d(perturbed, {low, 2}, {middle, 1}, {high, 0}), Sign::negative);
  // A square: its lower right corner moves out of the circle, its lower left one into it.
  const Point2 a{0, 0}, b{1, 0}, c{1, 1}, d{0, 1};
  EXPECT_EQ(incircle(perturbed, {a, 1}, {c, 2}, {d, 3}, {b, 0}), Sign::negative);
  EXPECT_EQ(incircle(perturbed, {b, 1}, {c, 2}, {d, 3}, {a, 0}), Sign::positive);
  // In a level plane x and y do not matter: the first rises, and none of the others does by as much.
  const Point3 p{0, 0, 0}, q{1, 0, 0}, r{0, 1, 0}, s{3, 4, 0};
  EXPECT_EQ(orient3d(perturbed, {p, 1}, {q, 2}, {r, 3}, {s, 0}), Sign::negative);
  const Point3 u{1, 1, 0};
  EXPECT_EQ(insphere(perturbed, {p, 1}, {q, 2}, {r, 3}, {{0, 0, -1}, 4}, {u, 0}), Sign::negative);
}

}  // namespace
}  // namespace plumb
