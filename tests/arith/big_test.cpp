// Is a BigDyadic the number that rationals say, below 1,024 bits, beyond, and back again?
#include "plumb/arith/big.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "plumb/degenerate/coordinates.hpp"

namespace plumb {
namespace {

struct Pair {
  BigDyadic number;
  mpq_class exact;
};

void expect_same(const Pair& p) {
  ASSERT_EQ(big_rational(p.number).value, p.exact);
  ASSERT_EQ(static_cast<int>(p.number.sign()), sgn(p.exact));
  ASSERT_EQ(sgn(p.number.mantissa()), sgn(p.exact));
}

std::size_t bits(const BigDyadic& x) { return mpz_sizeinbase(x.mantissa().get_mpz_t(), 2); }

Pair of(double x) { return {BigDyadic(x), mpq_class(x)}; }

double any_double(Entropy& e) {
  switch (e.below(6)) {
    case 0:
      return wide_coordinate(e);
    case 1:
      return extreme_coordinate(e);
    case 2:
      return static_cast<double>(e.below(5)) - 2;
    case 3:
      return std::numeric_limits<double>::denorm_min() * static_cast<double>(1 + e.below(3));
    case 4:
      return std::numeric_limits<double>::max() * (e.coin() ? 1 : -1);
    default:
      return unit_coordinate(e);
  }
}

TEST(BigDyadic, IsTheRationalNumberThroughManySteps) {
  int short_ones = 0, long_ones = 0, back = 0, zeros = 0;
  for (std::uint64_t run = 0; run < 60; ++run) {
    Entropy e(921, run);
    std::vector<Pair> all;
    for (int i = 0; i < 6; ++i) all.push_back(of(any_double(e)));
    for (int step = 0; step < 200; ++step) {
      SCOPED_TRACE(std::to_string(run) + "/" + std::to_string(step));
      const Pair a = all[e.below(all.size())], b = all[e.below(all.size())];
      Pair r;
      switch (e.below(5)) {
        case 0:
          r = {a.number + b.number, a.exact + b.exact};
          break;
        case 1:
          r = {a.number - b.number, a.exact - b.exact};
          break;
        case 2:
          r = {a.number * b.number, a.exact * b.exact};
          break;
        case 3: {  // a long sum that cancels
          const BigDyadic sum = a.number + b.number;
          r = {sum - a.number, b.exact};
          if (bits(sum) > 1024 && bits(r.number) <= 1024) ++back;
          break;
        }
        default:
          r = of(any_double(e));
          break;
      }
      expect_same(r);
      ++(bits(r.number) > 1024 ? long_ones : short_ones);
      if (r.number.sign() == Sign::zero) ++zeros;
      all[e.below(all.size())] = bits(r.number) > 6000 ? of(any_double(e)) : r;
    }
  }
  EXPECT_GT(short_ones, 3'000);
  EXPECT_GT(long_ones, 1'000);
  EXPECT_GT(back, 100);
  EXPECT_GT(zeros, 100);
}

// Where sixteen limbs are full, one bit more or less, at every alignment.
TEST(BigDyadic, AtTheEndOfItsLimbs) {
  for (int bit = 940; bit < 1100; ++bit) {
    SCOPED_TRACE(bit);
    mpz_class power = 1;
    power <<= static_cast<mp_bitcnt_t>(bit);
    for (const mpz_class& x : {power, mpz_class(power - 1), mpz_class(-power), mpz_class(1 - power)}) {
      const Pair p{BigDyadic(x), x};
      expect_same(p);
      for (const double d : {1.0, -1.0, 3.0, 0x1p-64, 0x1p63, 0x1p64}) {
        const mpq_class q(d);
        expect_same({p.number + BigDyadic(d), p.exact + q});
        expect_same({p.number - BigDyadic(d), p.exact - q});
        expect_same({p.number * BigDyadic(d), p.exact * q});
      }
      expect_same({p.number - p.number, 0});
      expect_same({p.number * p.number, p.exact * p.exact});
      EXPECT_EQ(BigDyadic(x).mantissa(), x);  // an integer stays as it is given
    }
  }
}

TEST(BigDyadic, CopiesAndMovesShortOnesAndLongOnes) {
  mpz_class power = 1;
  power <<= 5000;
  const Pair small = of(0.75), large{BigDyadic(mpz_class(power + 1)), mpz_class(power + 1)};
  for (const Pair* from : {&small, &large}) {
    for (const Pair* to : {&small, &large}) {
      BigDyadic copied = to->number, moved = to->number;
      copied = from->number;
      expect_same({copied, from->exact});
      moved = std::move(copied);
      expect_same({moved, from->exact});
      BigDyadic& itself = moved;
      moved = itself;
      expect_same({moved, from->exact});
      copied = to->number;
      expect_same({copied, to->exact});
      expect_same({magnitude(BigDyadic() - moved), from->exact});
    }
  }
}

}  // namespace
}  // namespace plumb
