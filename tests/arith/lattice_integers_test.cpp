#include "plumb/arith/lattice_integers.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "arith/samples.hpp"
#include "plumb/arith/lattice.hpp"

namespace plumb {
namespace {

using samples::power_of_two;
using samples::rational;

/// The integers must be the coordinates over one power of two; taken exactly where the lattice is in range.
template <std::size_t N>
void expect_the_coordinates(const std::array<double, N>& p, int& taken) {
  const LatticeIntegers<N> all(p);
  const Lattice lattice = lattice_of(p);
  const int top = lattice.exponent + lattice.bits;
  const bool in_range = lattice.bits > 0 && lattice.bits <= LatticeIntegers<N>::most_bits && top > -1014 && top <= 1021;
  SCOPED_TRACE(testing::Message() << std::hexfloat << p[0] << ' ' << p[1] << ' ' << p[N - 1]);
  ASSERT_EQ(all.bits() != 0, in_range);
  ASSERT_EQ((LatticeIntegers<N, 64>(p).bits()), top > 64 - 1023 ? all.bits() : 0);
  if (!in_range) return;
  ++taken;
  ASSERT_EQ(all.bits() - all.zeros(), std::min(lattice.bits, all.bits()));
  ASSERT_LE(all.bits(), LatticeIntegers<N>::most_bits);
  const mpq_class unit = power_of_two(top - all.bits());
  for (std::size_t i = 0; i < N; ++i) {
    ASSERT_TRUE(mpq_class(static_cast<long>(all.integer(i))) * unit == rational(p[i])) << i;
    ASSERT_EQ(all.integer(i) & ((1ll << all.zeros()) - 1), 0) << i;
    for (std::size_t j = 0; j < N; ++j) ASSERT_EQ(all.difference(i, j), all.integer(i) - all.integer(j));
  }
}

template <class T>
struct LatticeIntegersTest : testing::Test {};
using Sizes = testing::Types<std::array<double, 2>, std::array<double, 3>, std::array<double, 6>, std::array<double, 7>,
                             std::array<double, 12>, std::array<double, 15>>;
TYPED_TEST_SUITE(LatticeIntegersTest, Sizes);

TYPED_TEST(LatticeIntegersTest, AreTheCoordinatesOfEveryClass) {
  for (int k = 0; k < coordinate_class_count; ++k) {
    const auto which = static_cast<CoordinateClass>(k);
    int taken = 0;
    for (std::uint64_t i = 0; i < 1'000; ++i) {
      Entropy entropy(3, i);
      TypeParam p{};
      for (double& x : p) x = coordinate_of(which, entropy);
      expect_the_coordinates(p, taken);
    }
    const bool short_span = which == CoordinateClass::grid || which == CoordinateClass::near_half;
    EXPECT_GE(taken, short_span ? 990 : 0) << k;
  }
}

// Every width around the limits of the first step, of the second, and of both, at every exponent around the range's
// ends.
TYPED_TEST(LatticeIntegersTest, ReachAsFarAsTheySay) {
  int taken = 0;
  for (const int top : {-1073, -1023, -1022, -1015, -1014, -1013, -1012, -960, -959, -958, -52, 0, 1, 53, 1020, 1021,
                        1022, 1023, 1024}) {
    for (int bits = 1; bits <= 64; ++bits) {
      for (const double sign : {1.0, -1.0}) {
        TypeParam p{};
        p.front() = sign * std::ldexp(bits < 53 ? 1 - 0x1p-53 : 0.5, top);  // rounded where subnormal
        p.back() = -sign * std::ldexp(1, top - bits);
        if (bits < 53) p.front() = sign * std::ldexp(std::floor(std::ldexp(1 - 0x1p-53, bits)) * 2 - 1, top - bits - 1);
        expect_the_coordinates(p, taken);
      }
    }
  }
  EXPECT_GT(taken, 500);
}

TYPED_TEST(LatticeIntegersTest, RefuseWhatIsNoNumber) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), samples::infinity, -samples::infinity}) {
    for (const double other : {0.0, 1.0, -1e300, 1e-320}) {
      for (std::size_t i = 0; i < TypeParam{}.size(); ++i) {
        TypeParam p{};
        p.fill(other);
        p[i] = bad;
        EXPECT_EQ(LatticeIntegers(p).bits(), 0) << bad << ' ' << i;
      }
    }
  }
}

}  // namespace
}  // namespace plumb
