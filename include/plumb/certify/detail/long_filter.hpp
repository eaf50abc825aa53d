// What do numbers prove whose exponents are beyond those of all products of doubles?
//
// Filter A (arith/filtered.hpp) over long double, where that has 15 bits of exponent, as on x86-64 and AArch64: for
// coordinates whose exponents are so far apart that products of doubles vanish or overflow; of an alternating formula,
// seen from its least argument (alternating.hpp).
// Laws: a certain answer is the sign of the exact value, for finite coordinates; of no others is any certain.  Products of five
// coordinates or fewer lie between 2^-5370 and 2^5130, so that nothing overflows, and nothing underflows but to 0
// exactly.  A long double rounds no worse than a double, even where the machine is set to 53 bits: the constant of
// doubles holds.
// Source: docs/proof.md, "Filter A", "Alternating formulas".
// Cost: 10 to 120 ns.
#pragma once

#include <limits>

#include "plumb/certify/detail/alternating.hpp"
#include "plumb/certify/detail/exact_stages.hpp"
#include "plumb/certify/detail/filter_stage.hpp"

namespace plumb {
namespace certify {

struct LongFiltered {
  long double value, magnitude;

  constexpr LongFiltered(long double v, long double m) : value(v), magnitude(m) {}
  static constexpr long double size(long double x) { return x < 0 ? -x : x; }

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

/// A difference of coordinates as a double, which the machine keeps at less cost; or as a long double, which none is
/// too large for.
template <class Value>
struct LongDifference {
  Value value;

  struct Input {
    double value;
    friend constexpr LongDifference operator-(Input a, Input b) {
      return {static_cast<Value>(a.value) - static_cast<Value>(b.value)};
    }
  };
  constexpr operator LongFiltered() const { return {value, LongFiltered::size(value)}; }  // NOLINT: mixes with those

  friend constexpr LongFiltered operator*(LongDifference a, LongDifference b) {
    const long double v = static_cast<long double>(a.value) * static_cast<long double>(b.value);
    return {v, LongFiltered::size(v)};
  }
};

template <Formula F, class Value>
constexpr LongFiltered long_filtered(const Coordinates<F>& p) {
  return evaluate<F>([&](std::size_t i) { return typename LongDifference<Value>::Input{p[i]}; });
}

/// Do magnitudes differ by so much that hardly a lattice of the wide integers holds them?
template <Formula F>
bool is_spread(const Levels<F>& levels) {
  return levels.span() > integer::widest<F> - 53;
}

}  // namespace certify

/// Certain only of zeros that equal arguments force, of coordinates whose magnitudes are spread: others cost the integers less.
template <Formula F>
Unsure<Sign> repeated_argument_sign(const Coordinates<F>& p, const certify::Levels<F>& levels) {
  return certify::is_spread<F>(levels) && certify::repeats_argument<F>(p) ? Unsure{Sign::zero} : Unsure<Sign>{};
}

/// Of alternating formulas of differences; asked of coordinates whose magnitudes are spread, and of no others certain.
template <Formula F>
Unsure<Sign> long_double_sign(const Coordinates<F>& p, const certify::Levels<F>& levels) {
  static_assert(degree<F>() <= 5 && is_alternating<F>);
  if (!certify::is_spread<F>(levels)) return {};
  if constexpr (std::numeric_limits<long double>::max_exponent >= 16384 &&
                std::numeric_limits<long double>::digits >= 64) {
    const certify::LeastLast<F> seen(p);
    auto r = certify::long_filtered<F, double>(seen.at);
    if (!(r.magnitude - r.magnitude == 0)) r = certify::long_filtered<F, long double>(seen.at);
    const int s = beyond(r.value, static_cast<long double>(filter_constant<F>()) * r.magnitude);
    if (s != 0) return Unsure{static_cast<Sign>(s) * seen.parity};
  }
  return {};
}
template <Formula F>
Unsure<Sign> long_double_sign(const Coordinates<F>& p) {
  return long_double_sign<F>(p, certify::Levels<F>(p));
}

}  // namespace plumb
