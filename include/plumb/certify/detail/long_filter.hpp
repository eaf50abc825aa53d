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

/// Do magnitudes differ by so much that hardly a lattice of the wide integers holds them, which cost more?
template <Formula F>
bool is_spread(const Coordinates<F>& p) {
  constexpr double least_ratio = [] {
    double ratio = 1;
    for (int bits = 53; bits < integer::widest<F>; ++bits) ratio *= 2;
    return ratio;
  }();
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const double x : p) {
    const double size = x < 0 ? -x : x;
    most = size > most ? size : most;
    least = size < least && size > 0 ? size : least;
  }
  return most > least * least_ratio;
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
