// Which sign has an integer of which a double tells nearly all, and the lowest bits the rest?
//
// Volumes of lattice points take up to 190 bits.  But where the double lies beyond its error its sign is certain, and
// where it does not the integer is small: 128 bits are all of it, and what wraps around on the way to them does no
// harm.
// Laws: `error` is a filter's threshold, which bounds all but the last rounding of the value, so |value - exact| <= 2
// error.
// With error < most_error settled_sign is the sign of the exact integer: where |value| <= error, |exact| <= 3 error <
// 2^127, so that the word read as a signed number is exact.  Doubles of integers neither overflow nor underflow here:
// products of three differences stay below 2^190, and none lies between 0 and 1.
// Source: docs/proof.md for the thresholds.
// Cost: that of a double and of one or three products of words.
#pragma once

#include <cstdint>

#include "plumb/arith/filtered.hpp"
#include "plumb/arith/wide_int.hpp"

namespace plumb::arith {

inline constexpr double most_error = 0x1p125;

struct Wrapped {
  double value;
  UInt128 low;

  friend constexpr Wrapped operator+(const Wrapped& a, const Wrapped& b) { return {a.value + b.value, a.low + b.low}; }
  friend constexpr Wrapped operator-(const Wrapped& a, const Wrapped& b) { return {a.value - b.value, a.low - b.low}; }
};

/// A difference of coordinates, below 2^62 in magnitude: rounded once to a double, as differences of doubles are.
struct LatticeStep {
  double value;
  std::int64_t whole;

  explicit constexpr LatticeStep(std::int64_t difference) : value(static_cast<double>(difference)), whole(difference) {}

  friend constexpr Wrapped operator*(const LatticeStep& a, const LatticeStep& b) {
    return {a.value * b.value, static_cast<UInt128>(static_cast<Int128>(a.whole) * b.whole)};
  }
  friend constexpr Wrapped operator*(const LatticeStep& a, const Wrapped& b) {
    return {a.value * b.value, static_cast<UInt128>(static_cast<Int128>(a.whole)) * b.low};
  }
};

constexpr Sign settled_sign(const Wrapped& x, double error) {
  if (magnitude_of(x.value) > error) return sign_of_number(x.value);
  return sign_of_number(static_cast<Int128>(x.low));
}
template <int Bits>
constexpr Sign settled_sign(const WideInt<Bits>& x, double) {
  return x.sign();
}

}  // namespace plumb::arith
