// What do numbers prove whose exponents are beyond those of all products of doubles?
//
// Filter A (arith/filtered.hpp) over long double, where that has 15 bits of exponent, as on x86-64 and AArch64: for
// coordinates whose exponents are so far apart that products of doubles vanish or overflow.
// Laws: a certain answer is the sign of the exact value, for finite coordinates; of no others is any certain.  Products of five
// coordinates or fewer lie between 2^-5370 and 2^5130, so that nothing overflows, and nothing underflows but to 0
// exactly.  A long double rounds no worse than a double, even where the machine is set to 53 bits: the constant of
// doubles holds.
// Source: docs/proof.md, "Filter A".
// Cost: 20 to 50 ns; 2 to 5 where the exponents are not so far apart.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>

#include "plumb/certify/detail/exact_stages.hpp"
#include "plumb/certify/detail/filter_stage.hpp"

namespace plumb {
namespace certify {

struct LongFiltered {
  long double value, magnitude;

  constexpr LongFiltered(long double v, long double m) : value(v), magnitude(m) {}
  static constexpr long double size(long double x) { return x < 0 ? -x : x; }

  struct Input {
    double value;
    friend constexpr LongFiltered operator-(Input a, Input b) {
      const long double v = static_cast<long double>(a.value) - static_cast<long double>(b.value);
      return {v, size(v)};
    }
  };
  friend constexpr LongFiltered operator+(LongFiltered a, LongFiltered b) {
    return {a.value + b.value, a.magnitude + b.magnitude};
  }
  friend constexpr LongFiltered operator-(LongFiltered a, LongFiltered b) {
    return {a.value - b.value, a.magnitude + b.magnitude};
  }
  friend constexpr LongFiltered operator*(LongFiltered a, LongFiltered b) {
    return {a.value * b.value, a.magnitude * b.magnitude};
  }
};

/// Do magnitudes differ by so much that hardly a lattice of the wide integers holds them, which cost more?  By their bits,
/// because branches on magnitudes are not foreseen.
template <Formula F>
constexpr bool is_spread(const Coordinates<F>& p) {
  std::uint64_t least = ~std::uint64_t{0}, most = 0;  // least is one less, so that 0 is the largest
  for (const double x : p) {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x) & (~std::uint64_t{0} >> 1);
    most = bits > most ? bits : most;
    least = bits - 1 < least ? bits - 1 : least;
  }
  return (most >> 52) > ((least + 1) >> 52) + (integer::widest<F> - 53) && most != 0;
}

}  // namespace certify

/// Of formulas of differences; asked of coordinates whose magnitudes are spread, and of no others certain.
template <Formula F>
Unsure<Sign> long_double_sign(const Coordinates<F>& p) {
  static_assert(degree<F>() <= 5);
  if (!certify::is_spread<F>(p)) return {};
  if constexpr (std::numeric_limits<long double>::max_exponent >= 16384 &&
                std::numeric_limits<long double>::digits >= 64) {
    const auto r = evaluate<F>([&](std::size_t i) { return certify::LongFiltered::Input{p[i]}; });
    const int s = beyond(r.value, static_cast<long double>(filter_constant<F>()) * r.magnitude);
    if (s != 0) return Unsure{static_cast<Sign>(s)};
  }
  return {};
}

}  // namespace plumb
