#include "plumb/arith/lattice_digits.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "arith/samples.hpp"
#include "plumb/arith/lattice.hpp"

namespace plumb {
namespace {

using samples::power_of_two;
using samples::rational;

template <int Bits>
mpq_class exact(const WideInt<Bits>& x) {
  mpz_class sum = x.negative() ? -1 : 0;
  for (std::size_t i = x.limbs; i-- > 0;) sum = (sum << 64) + mpz_class(static_cast<unsigned long>(x.limb[i]));
  return sum;
}

/// Found exactly where the coordinates span no more than Bits, and then the coordinates over one power of two.
template <int Bits, std::size_t N>
void expect_the_coordinates(LatticeDigits<N, 509>& all, const std::array<double, N>& p, int& found) {
  const Lattice lattice = lattice_of(p);
  const int top = lattice.exponent + lattice.bits;
  SCOPED_TRACE(testing::Message() << Bits << " bits " << std::hexfloat << p[0] << ' ' << p[1] << ' ' << p[N - 1]);
  const bool extended = all.template extend<Bits>();
  const bool in_range = lattice.bits > 0 && top <= 1018 && top - 47 * ((Bits + 46) / 47) + 53 > -1022;
  ASSERT_EQ(extended, in_range && lattice.bits <= Bits) << top;
  if (!extended) return;
  ++found;
  const mpq_class unit = power_of_two(top - Bits);
  for (std::size_t i = 0; i < N; ++i) {
    ASSERT_TRUE(exact(all.template integer<Bits>(i)) * unit == rational(p[i])) << i;
    for (const std::size_t j : {std::size_t{0}, i / 2, N - 1}) {
      ASSERT_TRUE(exact(all.template difference<Bits>(i, j)) * unit == rational(p[i]) - rational(p[j]))
          << i << ' ' << j;
    }
  }
}

template <std::size_t N>
void expect_every_width(const std::array<double, N>& p, std::array<int, 5>& found) {
  LatticeDigits<N, 509> all(p);
  expect_the_coordinates<125>(all, p, found[0]);
  expect_the_coordinates<188>(all, p, found[1]);
  expect_the_coordinates<253>(all, p, found[2]);
  expect_the_coordinates<317>(all, p, found[3]);
  expect_the_coordinates<509>(all, p, found[4]);
}

template <class T>
struct LatticeDigitsTest : testing::Test {};
using Sizes = testing::Types<std::array<double, 2>, std::array<double, 7>, std::array<double, 12>>;
TYPED_TEST_SUITE(LatticeDigitsTest, Sizes);

// Exponents drawn from spans around every width, at every height of the format.
TYPED_TEST(LatticeDigitsTest, AreTheCoordinatesHoweverFarTheyLieApart) {
  std::array<int, 5> found{};
  for (std::uint64_t i = 0; i < 3'000 && !testing::Test::HasFatalFailure(); ++i) {
    Entropy entropy(4, i);
    const int top = static_cast<int>(entropy.within(1023));
    const std::int64_t span = std::array{60, 72, 125, 135, 200, 264, 456, 600}[entropy.below(8)];
    TypeParam p{};
    for (double& x : p) {
      const int exponent = top - static_cast<int>(entropy.below(static_cast<std::uint64_t>(span)));
      x = entropy.below(8) == 0 ? 0 : std::ldexp(signed_unit_coordinate(entropy), exponent);
    }
    expect_every_width(p, found);
  }
  for (const int n : found) EXPECT_GT(n, 200);
}

TYPED_TEST(LatticeDigitsTest, ReachAsFarAsTheySay) {
  std::array<int, 5> found{};
  for (const int top : {-1022, -971, -883, -830, -829, -600, -559, -558, -54, 0, 53, 1015, 1017, 1018, 1019, 1024}) {
    for (const int bits : {1, 53, 124, 125, 126, 141, 187, 188, 189, 252, 253, 254, 316, 317, 318, 508, 509, 510}) {
      TypeParam p{};
      p.front() = -std::ldexp(bits < 53 ? 0.5 : 1 - 0x1p-53, top);
      p.back() = std::ldexp(1, top - bits);
      if (p.back() != 0) expect_every_width(p, found);
    }
  }
  for (const int n : found) EXPECT_GT(n, 20);
}

TYPED_TEST(LatticeDigitsTest, RefuseWhatIsNoNumber) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), samples::infinity, -samples::infinity}) {
    for (const double other : {0.0, 1.0, -1e300, 1e-320}) {
      for (std::size_t i = 0; i < TypeParam{}.size(); ++i) {
        TypeParam p{};
        p.fill(other);
        p[i] = bad;
        LatticeDigits<TypeParam{}.size(), 509> all(p);
        EXPECT_FALSE(all.template extend<125>() || all.template extend<509>()) << bad << ' ' << i;
      }
    }
  }
}

}  // namespace
}  // namespace plumb
