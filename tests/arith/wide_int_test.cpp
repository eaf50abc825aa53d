#include "plumb/arith/wide_int.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <type_traits>

#include "arith/two_word_integer.hpp"
#include "plumb/degenerate.hpp"

namespace plumb {
namespace {

template <int Bits>
mpz_class exact(const WideInt<Bits>& x) {
  mpz_class r;
  mpz_import(r.get_mpz_t(), x.limb.size(), -1, sizeof(std::uint64_t), 0, 0, x.limb.data());
  if (x.negative()) r -= mpz_class(1) << static_cast<unsigned>(64 * WideInt<Bits>::limbs);
  return r;
}

template <int Bits>
WideInt<Bits> wide_of(mpz_class x) {
  WideInt<Bits> r;
  if (x < 0) x += mpz_class(1) << static_cast<unsigned>(64 * WideInt<Bits>::limbs);
  mpz_export(r.limb.data(), nullptr, -1, sizeof(std::uint64_t), 0, 0, x.get_mpz_t());
  return r;
}

// An integer below 2^bits in magnitude: the extremes, sparse and dense limbs, small ones.
mpz_class any_integer(int bits, Entropy& entropy) {
  const mpz_class most = (mpz_class(1) << static_cast<unsigned>(bits)) - 1;
  mpz_class x = 0;
  switch (entropy.below(5)) {
    case 0:
      x = most;
      break;
    case 1:
      x = mpz_class(1) << static_cast<unsigned>(entropy.below(static_cast<std::uint64_t>(bits)));
      break;
    case 2:
      x = most - mpz_class(static_cast<unsigned long>(entropy.below(3)));
      break;
    default:
      for (int i = 0; i < bits; i += 64) {
        const std::array<std::uint64_t, 4> limb{entropy.bits(64), 0, ~0ull, 1};
        x = (x << 64) + mpz_class(static_cast<unsigned long>(limb[entropy.below(4)]));
      }
      x = x & most;
      break;
  }
  if (x > most) x = most;
  return entropy.coin() ? mpz_class(-x) : x;
}

std::string told(const mpz_class& x, const mpz_class& y) { return x.get_str() + " and " + y.get_str(); }

template <int A, int B>
void check_operations(const mpz_class& x, const mpz_class& y) {
  const WideInt<A> a = wide_of<A>(x);
  const WideInt<B> b = wide_of<B>(y);
  ASSERT_TRUE(exact(a) == x);
  ASSERT_EQ(a.sign(), sign_of_number(x));
  static_assert(std::is_same_v<decltype(a + b), WideInt<std::max(A, B) + 1>>);
  static_assert(std::is_same_v<decltype(a * b), WideInt<A + B>>);
  ASSERT_TRUE(exact(a + b) == x + y) << told(x, y);
  ASSERT_TRUE(exact(a - b) == x - y) << told(x, y);
  ASSERT_TRUE(exact(b - a) == y - x) << told(y, x);
  if constexpr (A + B < 1024) {
    ASSERT_TRUE(exact(a * b) == x * y) << told(x, y);
    ASSERT_TRUE(exact(b * a) == x * y) << told(y, x);
    ASSERT_EQ((a * b).sign(), sign_of_number(mpz_class(x * y)));
  }
}

template <int A, int B>
void check_widths(Entropy& entropy) {
  SCOPED_TRACE(testing::Message() << A << " and " << B << " bits");
  const mpz_class most_a = (mpz_class(1) << A) - 1, most_b = (mpz_class(1) << B) - 1;
  const std::array<mpz_class, 6> xs{most_a, -most_a, 0, 1, -1, most_a / 2 + 1};
  const std::array<mpz_class, 6> ys{most_b, -most_b, 0, 1, -1, -most_b / 2 - 1};
  for (const mpz_class& x : xs)
    for (const mpz_class& y : ys) check_operations<A, B>(x, y);
  for (int i = 0; i < 500 && !testing::Test::HasFatalFailure(); ++i) {
    check_operations<A, B>(any_integer(A, entropy), any_integer(B, entropy));
  }
}

template <class Width>
struct WideIntTest : testing::Test {};

template <int Bits>
using Width = std::integral_constant<int, Bits>;

// Full and barely begun limbs, from 1 to 16 of them.
using Widths = testing::Types<Width<1>, Width<29>, Width<61>, Width<62>, Width<63>, Width<64>, Width<65>, Width<125>,
                              Width<126>, Width<127>, Width<128>, Width<189>, Width<191>, Width<253>, Width<256>,
                              Width<319>, Width<383>, Width<447>, Width<509>, Width<511>, Width<512>, Width<575>,
                              Width<639>, Width<703>, Width<767>, Width<831>, Width<895>, Width<959>, Width<1023>>;
TYPED_TEST_SUITE(WideIntTest, Widths);

TYPED_TEST(WideIntTest, AgreesWithGmp) {
  constexpr int bits = TypeParam::value;
  Entropy entropy(1, bits);
  check_widths<bits, 1>(entropy);
  check_widths<bits, 61>(entropy);
  check_widths<bits, 64>(entropy);
  check_widths<bits, 191>(entropy);
  if constexpr (bits <= 511) check_widths<bits, bits>(entropy);
}

TYPED_TEST(WideIntTest, ShiftsAMantissaToItsPlace) {
  constexpr int bits = TypeParam::value;
  Entropy entropy(2, bits);
  for (int shift = 0; shift < bits; ++shift) {
    for (int i = 0; i < 4; ++i) {
      const int length = std::min(bits - shift, 1 + static_cast<int>(entropy.below(53)));
      const auto most = static_cast<std::int64_t>(~0ull >> (64 - length));
      const std::int64_t m = i == 0 ? most : i == 1 ? -most : entropy.within(most);
      ASSERT_TRUE(exact(shifted<bits>(m, shift)) == mpz_class(static_cast<long>(m)) << static_cast<unsigned>(shift))
          << m << " << " << shift;
    }
  }
}

TYPED_TEST(WideIntTest, TakesBuiltInIntegers) {
  constexpr int bits = TypeParam::value;
  Entropy entropy(3, bits);
  for (int i = 0; i < 100; ++i) {
    const auto most = static_cast<std::int64_t>(~0ull >> (64 - std::min(bits, 63)));
    const std::int64_t m = i == 0 ? most : i == 1 ? -most : entropy.within(most / 2);
    ASSERT_TRUE(exact(WideInt<bits>{m}) == mpz_class(static_cast<long>(m)));
    ASSERT_EQ(WideInt<bits>{m}.low64(), m);
    if constexpr (WideInt<bits>::limbs >= 2) {
      constexpr int upper_bits = std::min(bits, 127) - 64;
      const std::uint64_t low = entropy.bits(64), high = entropy.bits(upper_bits);
      auto x = static_cast<Int128>(static_cast<UInt128>(high) << 64 | low);
      mpz_class expected =
          (mpz_class(static_cast<unsigned long>(high)) << 64) + mpz_class(static_cast<unsigned long>(low));
      if (i % 2 == 1) {
        x = -x;
        expected = -expected;
      }
      ASSERT_TRUE(exact(WideInt<bits>{x}) == expected);
      ASSERT_TRUE((WideInt<bits>{x}.low128() == x));
    }
  }
}

TEST(TwoWordInteger, IsExactUntilItIsLost) {
  int lost = 0, kept = 0;
  for (std::uint64_t i = 0; i < 5000; ++i) {
    Entropy e(4, i);
    const auto any = [&] { return static_cast<double>(e.within(std::int64_t{1} << (1 + e.below(50)))); };
    const double a = any(), b = e.below(4) == 0 ? a : any(), c = any(), d = any();
    const TwoWordInteger x(a), y(c), w(d), z = TwoWordInteger::difference(a, b), one(1.0);
    const mpz_class p(a), q(c), r(d), s = p - mpz_class(b);
    const auto expect = [&](const TwoWordInteger& told, const mpz_class& exact, std::size_t most) {
      const Unsure<Sign> sign = told.sign();
      (sign.certain() ? kept : lost) += 1;
      if (sign.certain()) {
        EXPECT_EQ(static_cast<int>(sign.value()), sgn(exact)) << i;
      } else {
        EXPECT_GT(most, 127u) << i;
      }
      EXPECT_FALSE((told * one).sign().certain() && !sign.certain()) << i;
    };
    const auto bits = [](const mpz_class& m) { return m == 0 ? 0 : mpz_sizeinbase(m.get_mpz_t(), 2); };
    expect(x * y - z * w, p * q - s * r, 1 + std::max(bits(p) + bits(q), bits(s) + bits(r)));
    expect(x * y * w + z, p * q * r + s, 1 + std::max(bits(p) + bits(q) + bits(r), bits(s)));
    expect((x - y) * (x + y) * z, (p - q) * (p + q) * s, 2 * (1 + std::max(bits(p), bits(q))) + bits(s));
  }
  EXPECT_GT(lost, 500);
  EXPECT_GT(kept, 5000);
}

constexpr WideInt<61> seven{std::int64_t{7}}, minus_three{std::int64_t{-3}};
static_assert((seven * minus_three + WideInt<30>{std::int64_t{21}}).sign() == Sign::zero);
static_assert((seven * seven * seven * minus_three).sign() == Sign::negative);
static_assert(shifted_by<200, 190>(-1).limb == shifted<200>(-1, 190).limb);
static_assert(shifted_by<127, 64>(-5).limb == shifted<127>(-5, 64).limb);
static_assert(shifted_by<189, 31>(1ll << 52).limb == shifted<189>(1ll << 52, 31).limb);
static_assert(fitting_sum(shifted<200>(-1, 190), shifted<200>(1, 190)).sign() == Sign::zero);
static_assert(shifted<200>(-1, 190).sign() == Sign::negative && shifted<200>(0, 190).sign() == Sign::zero);

}  // namespace
}  // namespace plumb
