// What does plain floating point say, and how large were its terms?  A value beside its magnitude: filter A.
//
// Law: with e the formula's Bound, |value - exact| <= e * magnitude; magnitude is never below |value|.  Every product
// adds a guard of 2^-968 to its magnitude: eps * guard >= 2^-1074 pays for its underflow.  Overflow and NaN end in a
// magnitude that nothing exceeds.  Proof: docs/proof.md.
// Source: RTCD 11.2.
// Cost: about one extra operation for each operation of the formula.
#pragma once

#include <bit>
#include <cstdint>

#include "plumb/predicates/standard.hpp"

namespace plumb {

/// From 2^-1021 on it pays for underflow; this much also keeps its product with any filter's constant a normal number:
/// subnormal ones cost several times as much, and zeros are common.
inline constexpr double underflow_guard = 0x1p-968;

/// |x| by clearing the sign bit: std::fabs is not constexpr in C++20.
constexpr double magnitude_of(double x) { return __builtin_fabs(x); }

/// Two doubles, of which one operation of the machine makes two others.
using TwoDoubles = double __attribute__((vector_size(16)));
inline TwoDoubles magnitude_of(TwoDoubles x) {
  using Bits = std::uint64_t __attribute__((vector_size(16)));
  return std::bit_cast<TwoDoubles>(std::bit_cast<Bits>(x) & Bits{~0ULL >> 1, ~0ULL >> 1});
}

/// Over doubles, or two of them at once.
template <class V>
struct FilteredOf {
  struct Input {  // a coordinate as given
    V value;
  };
  struct Rounded {  // one rounded sum of coordinates: its magnitude is its own absolute value
    V value;
  };

  V value, magnitude;

  constexpr FilteredOf(V v, V m) : value(v), magnitude(m) {}
  constexpr FilteredOf(Input x)
      : FilteredOf(x.value, magnitude_of(x.value)) {}  // NOLINT: mixes as a value of a formula
  constexpr FilteredOf(Rounded x) : FilteredOf(x.value, magnitude_of(x.value)) {}  // NOLINT: likewise

  friend constexpr Rounded operator-(Input a, Input b) { return {a.value - b.value}; }
  friend constexpr Rounded operator+(Input a, Input b) { return {a.value + b.value}; }
  friend constexpr FilteredOf operator*(Input a, Input b) { return Rounded{a.value} * Rounded{b.value}; }
  // |a| * |b| rounds like |a * b|: one product serves value and magnitude.
  friend constexpr FilteredOf operator*(Rounded a, Rounded b) {
    const V v = a.value * b.value;
    return {v, magnitude_of(v) + underflow_guard};
  }
  friend constexpr FilteredOf operator+(FilteredOf a, FilteredOf b) {
    return {a.value + b.value, a.magnitude + b.magnitude};
  }
  friend constexpr FilteredOf operator-(FilteredOf a, FilteredOf b) {
    return {a.value - b.value, a.magnitude + b.magnitude};
  }
  friend constexpr FilteredOf operator*(FilteredOf a, FilteredOf b) {
    return {a.value * b.value, a.magnitude * b.magnitude + underflow_guard};
  }
};
using Filtered = FilteredOf<double>;
using FilteredTwo = FilteredOf<TwoDoubles>;

}  // namespace plumb
