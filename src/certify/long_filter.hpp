// What do numbers prove whose exponents are beyond those of all products of doubles?
//
// Filter A (arith/filtered.hpp) over long double, where that has 15 bits of exponent, as on x86-64 and AArch64: for
// coordinates whose exponents are so far apart that products of doubles vanish or overflow.
// Laws: a certain answer is the sign of the exact value, for finite coordinates; 0 is unsure.  Products of five
// coordinates or fewer lie between 2^-5370 and 2^5130, so that nothing overflows, and nothing underflows but to 0
// exactly.  A long double rounds no worse than a double, even where the machine is set to 53 bits: the constant of
// doubles holds.
// Source: docs/proof.md, "Filter A".
// Cost: 20 to 50 ns.
#pragma once

#include <limits>

#include "plumb/certify/filter_stage.hpp"

namespace plumb::query {

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

/// -1, 0 or 1, where 0 is unsure; of formulas of differences.
template <Formula F>
int long_filter(const Coordinates<F>& p) {
  static_assert(degree<F>() <= 5);
  if constexpr (std::numeric_limits<long double>::max_exponent >= 16384 &&
                std::numeric_limits<long double>::digits >= 64) {
    const LongFiltered r = evaluate<F>([&](std::size_t i) { return LongFiltered::Input{p[i]}; });
    return beyond(r.value, static_cast<long double>(filter_constant<F>()) * r.magnitude);
  } else {
    return 0;
  }
}

}  // namespace plumb::query
