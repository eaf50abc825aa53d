// Laws of degenerate/ulps.hpp, degenerate/coordinates.hpp and degenerate/moves.hpp.
#include "plumb/degenerate/moves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "plumb/degenerate/coordinates.hpp"
#include "plumb/degenerate/points.hpp"
#include "plumb/degenerate/ulps.hpp"

namespace {

using plumb::Entropy;
constexpr double largest = std::numeric_limits<double>::max();

TEST(Ulps, StepsAgreeWithNextafter) {
  for (std::uint64_t i = 0; i < 5000; ++i) {
    Entropy entropy(51, i);
    const double x = plumb::extreme_coordinate(entropy);
    ASSERT_EQ(plumb::double_at(plumb::place_of(x)), x);
    ASSERT_EQ(plumb::moved_by_ulps(x, 1), x == largest ? x : std::nextafter(x, INFINITY));
    ASSERT_EQ(plumb::moved_by_ulps(x, -1), x == -largest ? x : std::nextafter(x, -INFINITY));
  }
  EXPECT_EQ(plumb::moved_by_ulps(-0.0, 1), 0x1p-1074);
  EXPECT_EQ(plumb::moved_by_ulps(0x1p-1074, -2), -0x1p-1074);
  EXPECT_EQ(plumb::moved_by_ulps(-largest, std::numeric_limits<std::int64_t>::max()), largest);
  EXPECT_EQ(plumb::moved_by_ulps(largest, std::numeric_limits<std::int64_t>::min()), -largest);
}

TEST(Ulps, MantissaAndExponentsAgreeWithFrexp) {
  for (std::uint64_t i = 0; i < 5000; ++i) {
    Entropy entropy(52, i);
    const double x = plumb::extreme_coordinate(entropy);
    if (x == 0) {
      ASSERT_EQ(plumb::mantissa_length(x), 0);
      continue;
    }
    int exponent = 0;
    std::frexp(x, &exponent);
    ASSERT_EQ(plumb::highest_exponent(x), exponent - 1);
    const double odd = std::ldexp(std::ldexp(x, -exponent), exponent - plumb::lowest_exponent(x));
    ASSERT_EQ(odd, std::trunc(odd));
    ASSERT_EQ(std::fabs(std::fmod(odd, 2)), 1);
  }
}

TEST(Coordinates, KeepToTheirClass) {
  int subnormal = 0, huge = 0, special = 0;
  std::set<double> halves;
  for (std::uint64_t i = 0; i < 20'000; ++i) {
    Entropy entropy(53, i);
    const double unit = plumb::unit_coordinate(entropy), both = plumb::signed_unit_coordinate(entropy);
    ASSERT_TRUE(unit >= 0 && unit < 1 && std::fabs(both) < 1);
    const double single = plumb::float32_coordinate(entropy);
    ASSERT_EQ(single, static_cast<double>(static_cast<float>(single)));
    const double grid = plumb::grid_coordinate(entropy, 7);
    ASSERT_TRUE(grid == std::trunc(grid) && std::fabs(grid) < 128);
    const double half = plumb::near_half_coordinate(entropy, 256);
    ASSERT_LE(std::fabs((half - 0.5) * 0x1p53), 256);
    halves.insert(half);
    const double wide = plumb::wide_coordinate(entropy);
    ASSERT_LT(std::fabs(wide), 0x1p41);
    const double extreme = plumb::extreme_coordinate(entropy);
    ASSERT_TRUE(std::isfinite(extreme));
    subnormal += std::fpclassify(extreme) == FP_SUBNORMAL;
    huge += std::fabs(extreme) > 0x1p1000;
    special += std::fabs(plumb::special_coordinate(entropy)) == largest;
  }
  EXPECT_GT(subnormal, 200);
  EXPECT_GT(huge, 200);
  EXPECT_GT(special, 200);
  EXPECT_EQ(halves.size(), 513u);
}

TEST(Coordinates, SmallestChoicesAreSimple) {
  for (int which = 0; which < plumb::coordinate_class_count; ++which) {
    Entropy none = Entropy::from_choices({});
    const double x = plumb::coordinate_of(static_cast<plumb::CoordinateClass>(which), none);
    EXPECT_EQ(x, which == static_cast<int>(plumb::CoordinateClass::near_half) ? 0.5 : 0.0);
  }
}

TEST(Moves, ScalingLosesNoBit) {
  int bottom = 0, top = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Entropy entropy(54, i);
    const auto before = plumb::coordinates3<4>(plumb::any_family(entropy), plumb::Degeneracy::coplanar, entropy);
    auto after = before;
    i % 2 == 0 ? plumb::scale_exactly(after, entropy) : plumb::scale_axes_exactly(after, 3, entropy);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::set<int> shifts;
      for (std::size_t k = axis; k < after.size(); k += 3) {
        ASSERT_EQ(plumb::mantissa_length(after[k]), plumb::mantissa_length(before[k]));
        ASSERT_EQ(std::signbit(after[k]), std::signbit(before[k]));
        if (before[k] == 0) continue;
        shifts.insert(plumb::lowest_exponent(after[k]) - plumb::lowest_exponent(before[k]));
        bottom += plumb::highest_exponent(after[k]) < -950;
        top += plumb::highest_exponent(after[k]) > 950;
      }
      ASSERT_LE(shifts.size(), 1u);
    }
  }
  EXPECT_GT(bottom, 2000);
  EXPECT_GT(top, 2000);
}

TEST(Moves, PermutationsKeepWhatThereIs) {
  std::set<std::vector<double>> axes, orders;
  for (std::uint64_t i = 0; i < 500; ++i) {
    Entropy entropy(55, i);
    std::vector<double> c = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    plumb::permute_axes(c, 3, entropy);
    axes.insert(c);
    for (std::size_t p = 0; p < 3; ++p) EXPECT_EQ(c[3 * p] + c[3 * p + 1] + c[3 * p + 2], 6 + 9 * double(p));
    c = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    plumb::permute_points(c, 3, entropy);
    orders.insert(c);
    for (std::size_t p = 0; p < 3; ++p) EXPECT_EQ(c[3 * p] + 2, c[3 * p + 2]);
  }
  EXPECT_EQ(axes.size(), 6u);
  EXPECT_EQ(orders.size(), 6u);
}

}  // namespace
