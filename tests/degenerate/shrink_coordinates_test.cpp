// Laws 1 to 4 of shrink_coordinates: known least coordinates are found, in a bounded number of calls.
#include <gtest/gtest.h>

#include <cmath>

#include "degenerate/rational_signs.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/degenerate/shrink.hpp"
#include "plumb/degenerate/ulps.hpp"

namespace {

using Coordinates = std::vector<double>;
using View = std::span<const double>;

TEST(ShrinkCoordinates, FindsShortNumbers) {
  const Coordinates start = {-0x1.921fb54442d18p+300, 0x1.5bf0a8b145769p-900, 12345.678};
  EXPECT_EQ(plumb::shrink_coordinates(start, 1, [](View) { return true; }), (Coordinates{0, 0, 0}));
  EXPECT_EQ(plumb::shrink_coordinates(start, 1, [](View c) { return c[2] > 1000; }), (Coordinates{0, 0, 1024}));
  EXPECT_EQ(plumb::shrink_coordinates(start, 1, [](View c) { return c[0] < 0; }), (Coordinates{-1, 0, 0}));
  EXPECT_EQ(plumb::shrink_coordinates(start, 1, [](View c) { return c[1] != 0; }), (Coordinates{0, 1, 0}));
  EXPECT_EQ(plumb::shrink_coordinates(start, 1, [](View c) { return c[1] > 0 && c[1] < 1e-3; }),
            (Coordinates{0, 0x1p-10, 0}));
}

TEST(ShrinkCoordinates, KeepsNegativeZeroOnlyWhereItMatters) {
  EXPECT_FALSE(std::signbit(plumb::shrink_coordinates({-0.0}, 1, [](View) { return true; })[0]));
  EXPECT_TRUE(std::signbit(plumb::shrink_coordinates({-0.0}, 1, [](View c) { return std::signbit(c[0]); })[0]));
}

TEST(ShrinkCoordinates, FindsEqualCoordinates) {
  const Coordinates start = {3.25, 7.5, 7.5, -1e17};
  EXPECT_EQ(plumb::shrink_coordinates(start, 1, [](View c) { return c[1] == c[2] && c[1] != 0 && c[1] != c[0]; }),
            (Coordinates{0, 1, 1, 0}));
}

TEST(ShrinkCoordinates, ExactlyCollinearStaysSoAndGetsSmall) {
  const auto fails = [](View c) {
    const std::size_t all[] = {0, 1, 2};
    const bool different =
        (c[0] != c[2] || c[1] != c[3]) && (c[2] != c[4] || c[3] != c[5]) && (c[0] != c[4] || c[1] != c[5]);
    return different && plumb_test::sign_of_flat(c, 2, all) == 0;
  };
  int found = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    plumb::Entropy entropy(31, i);
    Coordinates c(6);
    plumb::fill_points(plumb::Family::degenerate_long, plumb::Degeneracy::collinear, 2, c, entropy);
    if (!fails(c)) continue;
    ++found;
    const Coordinates least = plumb::shrink_coordinates(c, 2, fails);
    EXPECT_TRUE(fails(least));
    for (const double x : least) EXPECT_LE(std::fabs(x), 2) << i;
  }
  EXPECT_GT(found, 30);
}

// The double formula's wrong signs need long mantissas: what is left is as small as such a failure gets by steps.
TEST(ShrinkCoordinates, WrongSignOfTheDoubleFormulaStaysWrongAndGetsShorter) {
  const auto fails = [](View c) {
    const std::size_t all[] = {0, 1, 2};
    const double det = (c[0] - c[4]) * (c[3] - c[5]) - (c[1] - c[5]) * (c[2] - c[4]);
    return (det > 0) - (det < 0) != plumb_test::sign_of_flat(c, 2, all);
  };
  int found = 0, before = 0, after = 0;
  for (std::uint64_t i = 0; i < 200 && found < 10; ++i) {
    plumb::Entropy entropy(32, i);
    Coordinates c(6);
    plumb::fill_points(plumb::Family::off_by_ulps, plumb::Degeneracy::collinear, 2, c, entropy);
    if (!fails(c)) continue;
    ++found;
    const Coordinates least = plumb::shrink_coordinates(c, 2, fails, 3000);
    EXPECT_TRUE(fails(least));
    for (const double x : c) before += plumb::mantissa_length(x);
    for (const double x : least) after += plumb::mantissa_length(x);
  }
  EXPECT_EQ(found, 10);
  EXPECT_LT(3 * after, 2 * before);
}

TEST(ShrinkCoordinates, CallsAreBoundedAndEveryCandidateIsFinite) {
  for (const std::size_t most : {0u, 1u, 20u, 500u}) {
    std::size_t calls = 0;
    const auto fails = [&](View c) {
      ++calls;
      for (const double x : c) EXPECT_TRUE(std::isfinite(x));
      return c[0] > 0x1p1023 && c[1] < 0 && c[2] != 0 && std::fabs(c[2]) < 0x1p-1060;
    };
    const Coordinates start = {0x1.fffffffffffffp1023, -0x1.fffffffffffffp1023, 0x1.8p-1070, 0x1p-1074};
    const Coordinates least = plumb::shrink_coordinates(start, 2, fails, most);
    EXPECT_LE(calls, most);
    EXPECT_TRUE(fails(least));
  }
}

}  // namespace
