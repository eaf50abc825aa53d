#include "plumb/arith/lattice.hpp"

#include <gtest/gtest.h>

#include "arith/samples.hpp"

namespace plumb {
namespace {

using samples::power_of_two;
using samples::rational;

TEST(LatticeTest, OddFormIsTheDouble) {
  Entropy entropy(1);
  std::vector<double> values = samples::special_values();
  for (int i = 0; i < 100'000; ++i) values.push_back(samples::any_double(entropy));
  for (const double x : values) {
    const OddForm f = odd_form(x);
    if (x == 0) {
      ASSERT_EQ(f.mantissa, 0);
      continue;
    }
    ASSERT_EQ(f.mantissa & 1, 1) << std::hexfloat << x;
    ASSERT_TRUE(mpq_class(static_cast<long>(f.mantissa)) * power_of_two(f.exponent) == rational(x))
        << std::hexfloat << x;
  }
}

bool divides(int exponent, std::span<const double> coordinates) {
  return std::ranges::all_of(coordinates,
                             [&](double x) { return mpq_class(rational(x) / power_of_two(exponent)).get_den() == 1; });
}

TEST(LatticeTest, IsTheCoarsestAndItsIntegersTakeTheLeastBits) {
  Entropy entropy(2);
  for (int i = 0; i < 10'000; ++i) {
    std::vector<double> coordinates(2 * (1 + entropy.below(3)));
    fill_points(any_family(entropy), Degeneracy::collinear, 2, coordinates, entropy);
    const Lattice l = lattice_of(coordinates);
    if (std::ranges::all_of(coordinates, [](double x) { return x == 0; })) {
      ASSERT_EQ(l, Lattice{});
      continue;
    }
    ASSERT_TRUE(divides(l.exponent, coordinates));
    ASSERT_FALSE(divides(l.exponent + 1, coordinates));
    mpq_class largest = 0;
    for (const double x : coordinates) largest = std::max(largest, mpq_class(abs(rational(x))));
    ASSERT_TRUE(largest < power_of_two(l.exponent + l.bits));
    ASSERT_TRUE(largest >= power_of_two(l.exponent + l.bits - 1));
  }
}

TEST(LatticeTest, ReachesFromTheSmallestToTheLargestDouble) {
  const std::array both{std::numeric_limits<double>::denorm_min(), -std::numeric_limits<double>::max(), 0.0};
  EXPECT_EQ(lattice_of(both), (Lattice{-1074, 2098}));
  EXPECT_EQ(lattice_of(std::span(both).first(1)), (Lattice{-1074, 1}));
  EXPECT_EQ(lattice_of(std::span(both).subspan(1, 1)), (Lattice{971, 53}));
  EXPECT_EQ(lattice_of({}), Lattice{});
  EXPECT_EQ(lattice_of(std::span(both).last(1)), Lattice{});
}

constexpr std::array grid{3.0, -0.5, 12.25};
static_assert(lattice_of(grid) == Lattice{-2, 6});

}  // namespace
}  // namespace plumb
