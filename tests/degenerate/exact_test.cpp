// Law 1 of degenerate/exact.hpp: exactly degenerate in rationals, every subset of every set; and how long mantissas
// are.
#include "plumb/degenerate/exact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "degenerate/rational_signs.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/degenerate/ulps.hpp"

namespace {

using plumb::Degeneracy, plumb::Entropy;
using plumb_test::for_each_subset;

constexpr std::size_t points = 6;

// Whether every subset of points that could be in general position is degenerate as asked.
bool is_degenerate(Degeneracy degeneracy, std::size_t dimension, std::span<const double> c) {
  bool all = true;
  const bool plane = dimension == 2;
  const auto flat = [&](std::span<const std::size_t> s) { all &= plumb_test::sign_of_flat(c, dimension, s) == 0; };
  const auto round = [&](std::span<const std::size_t> s) { all &= plumb_test::sign_of_round(c, dimension, s) == 0; };
  const auto line = [&](std::span<const std::size_t> s) { all &= plumb_test::collinear_in_space(c, s); };
  const std::size_t count = c.size() / dimension;
  switch (degeneracy) {
    case Degeneracy::collinear:
      plane ? for_each_subset(count, 3, flat) : for_each_subset(count, 3, line);
      break;
    case Degeneracy::coplanar:
      for_each_subset(count, dimension + 1, flat);
      break;
    case Degeneracy::cocircular:
      for_each_subset(count, dimension + 2, round);
      if (!plane) for_each_subset(count, 4, flat);
      break;
    case Degeneracy::cospherical:
      for_each_subset(count, dimension + 2, round);
      break;
  }
  return all;
}

struct Tally {
  int cases = 0, degenerate = 0, all_different = 0, flatter = 0;
  double coordinates = 0, long_mantissas = 0, full_mantissas = 0, inexact_differences = 0, differences = 0;

  void add(Degeneracy degeneracy, std::size_t dimension, std::span<const double> c) {
    ++cases;
    degenerate += is_degenerate(degeneracy, dimension, c);
    bool different = true;
    for_each_subset(points, 2, [&](std::span<const std::size_t> s) {
      different &= !std::equal(&c[s[0] * dimension], &c[s[0] * dimension] + dimension, &c[s[1] * dimension]);
      for (std::size_t axis = 0; axis < dimension; ++axis) {
        const double a = c[s[0] * dimension + axis], b = c[s[1] * dimension + axis], d = a - b;
        differences += 1;
        inexact_differences += mpq_class(a) - mpq_class(b) != mpq_class(d);
      }
    });
    all_different += different;
    bool flat = true;
    for_each_subset(points, 3, [&](std::span<const std::size_t> s) {
      flat &= dimension == 2 ? plumb_test::sign_of_flat(c, 2, s) == 0 : plumb_test::collinear_in_space(c, s);
    });
    flatter += flat;
    for (const double x : c) {
      coordinates += 1;
      long_mantissas += plumb::mantissa_length(x) >= 48;
      full_mantissas += plumb::mantissa_length(x) == 53;
    }
  }
};

Tally tally(plumb::Family family, Degeneracy degeneracy, std::size_t dimension, int cases) {
  Tally made;
  std::vector<double> c(points * dimension);
  for (int i = 0; i < cases; ++i) {
    Entropy entropy(11, static_cast<std::uint64_t>(i));
    plumb::fill_points(family, degeneracy, static_cast<int>(dimension), c, entropy);
    made.add(degeneracy, dimension, c);
  }
  return made;
}

class Exact : public testing::TestWithParam<std::tuple<Degeneracy, std::size_t>> {};

TEST_P(Exact, IsDegenerateInRationalsAndMostlyOfDifferentPoints) {
  const auto [degeneracy, dimension] = GetParam();
  for (const plumb::Family family : {plumb::Family::degenerate_short, plumb::Family::degenerate_long}) {
    const Tally t = tally(family, degeneracy, dimension, 300);
    SCOPED_TRACE(name_of(family));
    EXPECT_EQ(t.degenerate, t.cases);
    EXPECT_GT(t.all_different, t.cases * (family == plumb::Family::degenerate_long ? 5 : 3) / 10);
    // Circles and planes are not lines in disguise, but for the planes that are meant to be.
    if (degeneracy == Degeneracy::cospherical || degeneracy == Degeneracy::cocircular) {
      EXPECT_LT(t.flatter, t.cases / 50);
    } else if (degeneracy == Degeneracy::coplanar && dimension == 3) {
      EXPECT_GT(t.flatter, t.cases / 50);
      EXPECT_LT(t.flatter, t.cases / 3);
    }
  }
}

TEST_P(Exact, LongMantissasAreLongAndDifferencesRound) {
  const auto [degeneracy, dimension] = GetParam();
  const Tally t = tally(plumb::Family::degenerate_long, degeneracy, dimension, 300);
  EXPECT_GT(t.long_mantissas / t.coordinates, 0.7);
  EXPECT_GT(t.full_mantissas / t.coordinates, 0.25);
  // On circles and spheres only those across nearly the whole diameter do.
  EXPECT_GT(t.inexact_differences / t.differences, is_flat(degeneracy) ? 0.05 : 0.001);
}

TEST_P(Exact, KeepsWithinTheBitsAskedFor) {
  const auto [degeneracy, dimension] = GetParam();
  for (int bits = plumb::least_exact_bits; bits <= 53; ++bits) {
    double most = 0;
    for (std::uint64_t i = 0; i < 200; ++i) {
      Entropy entropy(static_cast<std::uint64_t>(bits), i);
      std::vector<double> c(points * dimension);
      plumb::fill_exact(degeneracy, static_cast<int>(dimension), bits, c, entropy);
      for (const double x : c) {
        ASSERT_EQ(x, std::trunc(x));
        most = std::max(most, std::fabs(x));
      }
      if (i < 3) {
        ASSERT_TRUE(is_degenerate(degeneracy, dimension, c)) << bits;
      }
    }
    EXPECT_LT(most, std::ldexp(1.0, bits));
    EXPECT_GE(most, std::ldexp(1.0, bits - 2)) << "the bits asked for are used";
  }
}

INSTANTIATE_TEST_SUITE_P(All, Exact, testing::Combine(testing::ValuesIn(plumb::degeneracies), testing::Values(2, 3)),
                         [](const auto& each) {
                           return std::string(name_of(std::get<0>(each.param))) +
                                  std::to_string(std::get<1>(each.param));
                         });

TEST(ExactCircle, HoldsManyDifferentPoints) {
  Entropy entropy(5);
  std::vector<double> c(2 * 2000);
  plumb::fill_exact(Degeneracy::cocircular, 2, 40, c, entropy);
  std::vector<std::pair<double, double>> all;
  for (std::size_t i = 0; i < c.size(); i += 2) all.emplace_back(c[i], c[i + 1]);
  std::sort(all.begin(), all.end());
  EXPECT_EQ(std::unique(all.begin(), all.end()) - all.begin(), 128);
}

TEST(ExactSet, AllZeroChoicesMakeTheSimplestCase) {
  for (const Degeneracy degeneracy : plumb::degeneracies) {
    Entropy none = Entropy::from_choices({});
    std::array<double, 15> c;
    plumb::fill_exact(degeneracy, 3, 20, c, none);
    for (const double x : c) EXPECT_LE(std::fabs(x), 1) << name_of(degeneracy);
  }
}

// The rational check itself can fail: a point off by one ulp is seen.
TEST(ExactCheck, SeesOneUlp) {
  std::array<double, 8> circle = {1, 0, 0, 1, -1, 0, 0, -1};
  EXPECT_TRUE(is_degenerate(Degeneracy::cocircular, 2, circle));
  circle[7] = plumb::moved_by_ulps(circle[7], 1);
  EXPECT_FALSE(is_degenerate(Degeneracy::cocircular, 2, circle));
}

}  // namespace
