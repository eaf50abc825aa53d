// Where does each arithmetic end?  At the bits derived, and not before: one more, and it would err.
#include "plumb/certify/plan.hpp"

#include <gtest/gtest.h>

#include "certify/lattice_cases.hpp"
#include "plumb/arith/error.hpp"

namespace plumb {
namespace {

using namespace lattice_cases;
using namespace predicates;

constexpr std::array ends{certify::planned::plain_double<Orient2d>, certify::planned::two_words<Orient2d>,
                          certify::planned::plain_double<Orient3d>, certify::planned::one_word_factors<Orient3d>,
                          certify::planned::modulo_word<Orient3d>,  certify::planned::two_words<Orient3d>,
                          certify::planned::plain_double<InCircle>, certify::planned::one_word_factors<InCircle>,
                          certify::planned::plain_double<InSphere>, certify::planned::one_word_factors<InSphere>,
                          certify::planned::modulo_word<InSphere>,  certify::planned::two_words<InSphere>};
static_assert(ends == std::array{25, 62, 16, 20, 35, 40, 11, 20, 8, 19, 20, 23});

static_assert(std::array{certify::planned::several_words<Orient3d>, certify::planned::several_words<InCircle>,
                         certify::planned::several_words<InSphere>} == std::array{62, 61, 48});

static_assert(arithmetic_for<Orient3d>(16) == Arithmetic::plain_double);
static_assert(arithmetic_for<Orient3d>(17) == Arithmetic::one_word_factors);
static_assert(arithmetic_for<Orient3d>(21) == Arithmetic::modulo_word);
static_assert(arithmetic_for<Orient3d>(36) == Arithmetic::two_words);
static_assert(arithmetic_for<Orient3d>(41) == Arithmetic::bounded_chain);
static_assert(arithmetic_for<Orient2d>(26) == Arithmetic::modulo_word);
static_assert(arithmetic_for<Orient2d>(52) == Arithmetic::two_words);
static_assert(arithmetic_for<Orient2d>(63) == Arithmetic::bounded_chain);
static_assert(arithmetic_for<InCircle>(21) == Arithmetic::modulo_word);
static_assert(arithmetic_for<InCircle>(60) == Arithmetic::bounded_chain);
static_assert(arithmetic_for<InSphere>(60) == Arithmetic::chain);
static_assert(arithmetic_for<PlaneSide>(200) == Arithmetic::chain);
static_assert(arithmetic_for<Paraboloid>(1) == Arithmetic::chain);
static_assert(arithmetic_for<Order>(51) == Arithmetic::plain_double);

template <class F>
class PlanTest : public testing::Test {};
using Formulas = testing::Types<Orient2d, Orient3d, InCircle, InSphere>;
TYPED_TEST_SUITE(PlanTest, Formulas);

// The share of wrong signs of plain doubles on exactly degenerate sets that reach the lattice's ends.
template <Formula F>
std::uint64_t wrong_doubles(int bits) {
  std::uint64_t wrong = 0;
  for (std::uint64_t i = 0; i < 60'000; ++i) {
    const Coordinates<F> p = coordinates_on<F>({0, bits}, 3 * i + 1);
    wrong += sign_of_number(F{}(p)) != decide<F>(p);
  }
  return wrong;
}

TYPED_TEST(PlanTest, PlainDoublesAreExactToTheEnd) {
  using F = TypeParam;
  constexpr int end = certify::planned::plain_double<F>;
  EXPECT_EQ(wrong_doubles<F>(end), 0u);
  EXPECT_EQ(certify::planned::error<F>(end).root, 0);
  EXPECT_GT(certify::planned::error<F>(end + 1).root, 0);
  if (degree<F>() > 2) {  // products that are equal round to equal doubles: see below
    EXPECT_GT(wrong_doubles<F>(end + 4), 0u);
  }
}

// Differences 2m, 2m - 1 and 2m - 1, 2m - 2, whose determinant is -1.
Coordinates<Orient2d> nearly_collinear(int bits) {
  const double m = certify::planned::largest_of(bits);
  return {m, m - 1, m - 1, m - 2, -m, -m};
}

TEST(PlanTest, OneBitMoreAndDoublesOfOrient2dAreWrong) {
  constexpr int end = certify::planned::plain_double<Orient2d>;
  EXPECT_EQ(sign_of_number(Orient2d{}(nearly_collinear(end))), Sign::negative);
  EXPECT_EQ(sign_of_number(Orient2d{}(nearly_collinear(end + 1))), Sign::zero);
  for (int bits = 2; bits <= 53; ++bits) {
    const Kernel kernel(plan(Lattice{0, bits}));
    EXPECT_EQ(sign_of_points<Orient2d>(kernel, nearly_collinear(bits)), Sign::negative) << bits;
  }
}

TYPED_TEST(PlanTest, MoreBitsAreNeverCheaper) {
  using F = TypeParam;
  for (int bits = 1; bits < 100; ++bits) EXPECT_LE(arithmetic_for<F>(bits - 1), arithmetic_for<F>(bits)) << bits;
}

TYPED_TEST(PlanTest, IntegersFitTheirWords) {
  using F = TypeParam;
  EXPECT_LT(certify::planned::error<F>(certify::planned::modulo_word<F>).root, 0x1p62);
  EXPECT_LE(certify::planned::growth<F>(certify::planned::two_words<F>).bits, 127);
  EXPECT_LE(certify::planned::growth<F>(certify::planned::several_words<F>).bits, 255);
  if (degree<F>() < 3) return;  // doubles with a bound come first
  const WidthGrowth end = certify::planned::growth<F>(certify::planned::one_word_factors<F>);
  EXPECT_LE(end.widest_factor, 63);
  EXPECT_LE(end.bits, 127);
}

TEST(PlanTest, SaysWhatItIsCalled) {
  const Plan scene = plan(Lattice{-10, 20});
  EXPECT_EQ(scene.lattice(), (Lattice{-10, 20}));
  EXPECT_EQ(to_string(scene.arithmetic<Orient2d>()), "plain double");
  EXPECT_EQ(to_string(scene.arithmetic<Orient3d>()), "integers to 128 bits");
  EXPECT_EQ(to_string(scene.arithmetic<InSphere>()), "bounded double, then integers modulo 2^64");
  EXPECT_EQ(to_string(Arithmetic::two_words), "bounded double, then integers to 128 bits");
  EXPECT_EQ(to_string(scene.arithmetic<Paraboloid>()), "the chain of stages");
  EXPECT_EQ(to_string(Arithmetic::bounded_chain), "bounded double, then the chain of stages");
}

TEST(PlanTest, RefusesLatticesOfNoDouble) {
  for (const Lattice& l : {Lattice{-1075, 3}, Lattice{1000, 25}, Lattice{0, -1}, Lattice{-1074, 2099}, Lattice{1024, 0},
                           Lattice{1 << 30, 1}, Lattice{0, 1 << 30}}) {
    EXPECT_THROW(plan(l), Error) << l.exponent << ' ' << l.bits;
    EXPECT_THROW(Kernel{l}, Error) << l.exponent << ' ' << l.bits;
  }
  EXPECT_NO_THROW(plan(Lattice{-1074, 2098}));
  EXPECT_NO_THROW(plan(Lattice{1023, 1}));
  EXPECT_NO_THROW(plan(Lattice{}));
}

}  // namespace
}  // namespace plumb
