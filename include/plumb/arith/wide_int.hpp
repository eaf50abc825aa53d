// What is the exact value, in integers?  Two's-complement integers of a fixed width that grows through the expression.
//
// Laws: WideInt<B> holds every integer with |x| < 2^B.  A sum has one bit more than its longer term, a product the bits
// of both factors: nothing overflows, nothing is allocated, and no more limbs are computed than the value can need.
// Source: Knuth, TAOCP 4.3.1; RTCD 11.5.1.
// Cost: one 64x64-bit product for each pair of limbs; no branch on values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "plumb/arith/sign.hpp"

namespace plumb {

__extension__ using Int128 = __int128;
__extension__ using UInt128 = unsigned __int128;

template <int Bits>
struct WideInt {
  static_assert(Bits > 0);
  static constexpr int bits = Bits;
  static constexpr std::size_t limbs = Bits / 64 + 1;  // Bits and a sign bit

  std::array<std::uint64_t, limbs> limb{};  // least significant first

  constexpr WideInt() = default;
  constexpr explicit WideInt(std::int64_t x) {
    limb[0] = static_cast<std::uint64_t>(x);
    for (std::size_t i = 1; i < limbs; ++i) limb[i] = static_cast<std::uint64_t>(x >> 63);
  }
  constexpr explicit WideInt(Int128 x) requires(limbs >= 2) {
    limb[0] = static_cast<std::uint64_t>(x);
    limb[1] = static_cast<std::uint64_t>(x >> 64);
    for (std::size_t i = 2; i < limbs; ++i) limb[i] = static_cast<std::uint64_t>(x >> 127);
  }

  [[nodiscard]] constexpr bool negative() const { return static_cast<std::int64_t>(limb[limbs - 1]) < 0; }
  /// All ones when negative: the limbs beyond the last.
  [[nodiscard]] constexpr std::uint64_t extension() const {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(limb[limbs - 1]) >> 63);
  }
  [[nodiscard]] constexpr std::uint64_t limb_or_extension(std::size_t i) const {
    return i < limbs ? limb[i] : extension();
  }
  /// The value of the lowest one (two) limbs as a built-in integer; the whole value when there are no more.
  [[nodiscard]] constexpr std::int64_t low64() const { return static_cast<std::int64_t>(limb[0]); }
  [[nodiscard]] constexpr Int128 low128() const {
    return static_cast<Int128>(static_cast<UInt128>(limb_or_extension(1)) << 64 | limb[0]);
  }

  [[nodiscard]] constexpr Sign sign() const {
    if constexpr (limbs == 1) return sign_of_number(low64());
    if constexpr (limbs == 2) return sign_of_number(low128());
    std::uint64_t any = 0;
#pragma GCC unroll 16
    for (std::size_t i = 0; i < limbs; ++i) any |= limb[i];  // not in vectors, which wait for limbs just stored
    return static_cast<Sign>(any == 0 ? 0 : negative() ? -1 : 1);
  }
};

namespace arith::wide {

constexpr int sum_bits(int a, int b) { return (a > b ? a : b) + 1; }

// a + b + carry and a - b - borrow; the carry ends as 0 or 1.  By the instruction that does it, where compilers do not
// find it by themselves.
constexpr std::uint64_t add(std::uint64_t a, std::uint64_t b, std::uint8_t& carry) {
#if defined(__x86_64__) && defined(__GNUC__)
  if (!std::is_constant_evaluated()) {
    unsigned long long sum = 0;
    carry = __builtin_ia32_addcarryx_u64(carry, a, b, &sum);
    return sum;
  }
#endif
  const UInt128 s = static_cast<UInt128>(a) + b + carry;
  carry = static_cast<std::uint8_t>(s >> 64);
  return static_cast<std::uint64_t>(s);
}
constexpr std::uint64_t subtract(std::uint64_t a, std::uint64_t b, std::uint8_t& borrow) {
#if defined(__x86_64__) && defined(__GNUC__)
  if (!std::is_constant_evaluated()) {
    unsigned long long difference = 0;
#if defined(__clang__)
    borrow = __builtin_ia32_subborrow_u64(borrow, a, b, &difference);
#else
    borrow = __builtin_ia32_sbb_u64(borrow, a, b, &difference);
#endif
    return difference;
  }
#endif
  const UInt128 d = static_cast<UInt128>(a) - b - borrow;
  borrow = static_cast<std::uint8_t>(d >> 64 & 1);
  return static_cast<std::uint64_t>(d);
}

}  // namespace arith::wide

template <int A, int B>
constexpr WideInt<arith::wide::sum_bits(A, B)> operator+(const WideInt<A>& a, const WideInt<B>& b) {
  using Result = WideInt<arith::wide::sum_bits(A, B)>;
  Result r;
  if constexpr (Result::limbs == 1) {
    r.limb[0] = a.limb[0] + b.limb[0];
  } else if constexpr (Result::limbs == 2) {
    return Result{a.low128() + b.low128()};
  } else {
    std::uint8_t carry = 0;
#pragma GCC unroll 16
    for (std::size_t i = 0; i < Result::limbs; ++i)
      r.limb[i] = arith::wide::add(a.limb_or_extension(i), b.limb_or_extension(i), carry);
  }
  return r;
}

template <int A, int B>
constexpr WideInt<arith::wide::sum_bits(A, B)> operator-(const WideInt<A>& a, const WideInt<B>& b) {
  using Result = WideInt<arith::wide::sum_bits(A, B)>;
  Result r;
  if constexpr (Result::limbs == 1) {
    r.limb[0] = a.limb[0] - b.limb[0];
  } else if constexpr (Result::limbs == 2) {
    return Result{a.low128() - b.low128()};
  } else {
    std::uint8_t borrow = 0;
#pragma GCC unroll 16
    for (std::size_t i = 0; i < Result::limbs; ++i) {
      r.limb[i] = arith::wide::subtract(a.limb_or_extension(i), b.limb_or_extension(i), borrow);
    }
  }
  return r;
}

template <int A, int B>
constexpr WideInt<A + B> operator*(const WideInt<A>& a, const WideInt<B>& b) {
  using Result = WideInt<A + B>;
  constexpr std::size_t na = WideInt<A>::limbs, nb = WideInt<B>::limbs, n = Result::limbs;
  Result r;
  if constexpr (n == 1) {
    r.limb[0] = a.limb[0] * b.limb[0];
  } else if constexpr (na == 1 && nb == 1) {
    return Result{static_cast<Int128>(a.low64()) * b.low64()};
  } else {
    // The unsigned product of the limbs, modulo 2^(64 * n) ...
#pragma GCC unroll 16
    for (std::size_t i = 0; i < na; ++i) {
      std::uint64_t carry = 0;
#pragma GCC unroll 16
      for (std::size_t j = 0; j < nb; ++j) {
        if (i + j >= n) break;
        const UInt128 t = static_cast<UInt128>(a.limb[i]) * b.limb[j] + r.limb[i + j] + carry;
        r.limb[i + j] = static_cast<std::uint64_t>(t);
        carry = static_cast<std::uint64_t>(t >> 64);
      }
      if (i + nb < n) r.limb[i + nb] = carry;
    }
    // ... counts a negative factor as 2^(64 * limbs) too much: take the other factor off again there.
    std::uint8_t borrow = 0;
#pragma GCC unroll 16
    for (std::size_t k = na; k < n; ++k) {
      r.limb[k] = arith::wide::subtract(r.limb[k], b.limb_or_extension(k - na) & a.extension(), borrow);
    }
    borrow = 0;
#pragma GCC unroll 16
    for (std::size_t k = nb; k < n; ++k) {
      r.limb[k] = arith::wide::subtract(r.limb[k], a.limb_or_extension(k - nb) & b.extension(), borrow);
    }
  }
  return r;
}

/// m * 2^shift, for a shift and a product that fit: |m| * 2^shift < 2^Bits.
template <int Bits>
constexpr WideInt<Bits> shifted(std::int64_t m, int shift) {
  WideInt<Bits> r;
  const std::size_t word = static_cast<std::size_t>(shift) / 64;
  const int bit = shift % 64;
  const auto low = static_cast<std::uint64_t>(m) << bit;
  const auto high = static_cast<std::uint64_t>(m >> (63 - bit) >> 1);
  const auto extension = static_cast<std::uint64_t>(m >> 63);
  for (std::size_t i = 0; i < r.limbs; ++i) {
    r.limb[i] = i < word ? 0 : i == word ? low : i == word + 1 ? high : extension;
  }
  return r;
}

/// Likewise, for a shift known when compiled.
template <int Bits, int Shift>
constexpr WideInt<Bits> shifted_by(std::int64_t m) {
  WideInt<Bits> r;
  constexpr std::size_t word = Shift / 64;
  constexpr int bit = Shift % 64;
  for (std::size_t i = word; i < r.limbs; ++i) {
    r.limb[i] = i == word       ? static_cast<std::uint64_t>(m) << bit
                : i == word + 1 ? static_cast<std::uint64_t>(m >> (63 - bit) >> 1)
                                : static_cast<std::uint64_t>(m >> 63);
  }
  return r;
}

/// a + b, when that needs no bit more.
template <int Bits>
constexpr WideInt<Bits> fitting_sum(const WideInt<Bits>& a, const WideInt<Bits>& b) {
  WideInt<Bits> r;
  std::uint8_t carry = 0;
#pragma GCC unroll 16
  for (std::size_t i = 0; i < r.limbs; ++i) r.limb[i] = arith::wide::add(a.limb[i], b.limb[i], carry);
  return r;
}

}  // namespace plumb
