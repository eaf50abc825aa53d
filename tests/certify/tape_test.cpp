#include "plumb/certify/detail/tape.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "arith/samples.hpp"
#include "arith/watched.hpp"
#include "plumb/arith/big.hpp"

namespace plumb {
namespace {

// Replays a program over numbers of any one type.
template <class T>
T replay(const certify::tape::Program& program, std::vector<T> number) {
  for (const certify::tape::Instruction& i : program.instructions) {
    const T l = number[i.left], r = number[i.right];
    number.push_back(i.operation == '+' ? T(l + r) : i.operation == '-' ? T(l - r) : T(l * r));
  }
  return number.back();
}

TEST(TapeTest, ReplayDoesExactlyWhatTheFormulaDoes) {
  for_each_formula([]<Formula F>() {
    SCOPED_TRACE(F::name);
    Entropy entropy(1);
    Coordinates<F> p{};
    for (int i = 0; i < 5'000; ++i) {
      fill_points(any_family(entropy), Degeneracy::cocircular, F::dimension, p, entropy);
      // Bit for bit, roundings, overflows and NaN included: the same operations in the same order.
      const double direct = value_of<F>(p),
                   replayed = replay(certify::tape::program<F>(), std::vector<double>(p.begin(), p.end()));
      ASSERT_TRUE(std::bit_cast<std::uint64_t>(direct) == std::bit_cast<std::uint64_t>(replayed) ||
                  (direct != direct && replayed != replayed));
    }
  });
}

TEST(TapeTest, NamesEarlierResultsOnly) {
  for_each_formula([]<Formula F>() {
    const certify::tape::Program p = certify::tape::program<F>();
    EXPECT_EQ(p.arity, arity<F>);
    std::vector<bool> used(p.arity + p.instructions.size());
    for (std::size_t i = 0; i < p.instructions.size(); ++i) {
      const certify::tape::Instruction& at = p.instructions[i];
      ASSERT_LT(at.left, p.arity + i);
      ASSERT_LT(at.right, p.arity + i);
      ASSERT_TRUE(at.operation == '+' || at.operation == '-' || at.operation == '*');
      used[at.left] = used[at.right] = true;
    }
    for (std::size_t i = 0; i + 1 < used.size(); ++i)
      EXPECT_TRUE(used[i]) << F::name << " computes " << i << " in vain";
  });
}

TEST(TapeTest, IsOfFixedLength) {
  certify::tape::Tape<1> tape;
  tape.arity = 2;
  EXPECT_EQ(tape.write('+', 0, 1), 2);
  EXPECT_THROW(tape.write('*', 0, 1), std::length_error);
}

mpq_class rational(const BigDyadic& x) {
  return mpq_class(x.mantissa()) * samples::power_of_two(static_cast<int>(x.exponent()));
}

TEST(BigTest, DyadicsAndRationalsAreTheDoublesExactly) {
  Entropy entropy(2);
  std::vector<double> values = samples::special_values();
  for (int i = 0; i < 20'000; ++i) values.push_back(samples::any_double(entropy));
  for (const double x : values) {
    ASSERT_TRUE(big_rational(x).value == samples::rational(x));
    ASSERT_EQ(big_rational(x).sign(), sign_of_number(x));
    ASSERT_TRUE(rational(BigDyadic(x)) == samples::rational(x));
    ASSERT_EQ(BigDyadic(x).sign(), sign_of_number(x));
  }
}

TEST(BigTest, DyadicsAddAndMultiplyExactlyWithoutTrailingLimbs) {
  Entropy entropy(3);
  std::vector<double> values = samples::special_values();
  for (int i = 0; i < 200; ++i) values.push_back(samples::any_double(entropy));
  for (const double x : values) {
    for (const double y : values) {
      const BigDyadic a(x), b(y);
      const mpq_class p = samples::rational(x), q = samples::rational(y);
      ASSERT_TRUE(rational(a + b) == p + q) << x << " + " << y;
      ASSERT_TRUE(rational(a - b) == p - q) << x << " - " << y;
      ASSERT_TRUE(rational(a * b) == p * q) << x << " * " << y;
      ASSERT_EQ((a - b).sign(), sign_of_number(cmp(p, q)));
      // A sum that cancels back to a coordinate is as short as the coordinate.
      const BigDyadic back = (a + b) - b;
      ASSERT_TRUE(rational(back) == p);
      ASSERT_LE(mpz_sizeinbase(back.mantissa().get_mpz_t(), 2), 53U + GMP_NUMB_BITS);
    }
  }
}

TEST(BigTest, RationalOperatorsAreGmps) {
  const BigRational third{mpq_class(1, 3)};
  EXPECT_EQ((third + third + third - BigRational{mpq_class(1)}).sign(), Sign::zero);
  EXPECT_EQ((third * BigRational{mpq_class(-3)}).sign(), Sign::negative);
}

}  // namespace
}  // namespace plumb
