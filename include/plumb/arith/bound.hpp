// Static filter: by how much can the floating-point value of a formula be off?  A number that computes its own error
// bound when compiled: run over Bound, a formula yields the constant of its filter.
//
// Law: |computed - exact| <= e * 2^-85 * magnitude, with the magnitude as Filtered computes it (arith/filtered.hpp).
// e is a 64-bit fixed-point number in units of 2^-85 = 2^-53 * 2^-32, every step rounded up.  Proof: docs/proof.md.
// Source: RTCD 11.2; the idea is that of static filters, with the underflow guard in the magnitude.
// Cost: none at run time.
#pragma once

#include <cstdint>

#include "plumb/predicates/standard.hpp"

namespace plumb {

/// Throws std::overflow_error; where the compiler derives a bound, the formula is refused by this name.
[[noreturn]] void throw_bound_too_large();

/// Error bound of an intermediate value.
struct Bound {
  struct Input {};  // a coordinate as given, which carries no error

  std::uint64_t e;     // bound with the value's own rounding
  std::uint64_t root;  // without its last rounding: rounding is monotone, so it cannot carry a sign past a double

  static constexpr double unit = 0x1p-85;           // of e and root
  static constexpr std::uint64_t eps = 1ull << 32;  // 2^-53, half an ulp of one

  constexpr Bound(std::uint64_t e_, std::uint64_t root_) : e(e_), root(root_) {}
  constexpr Bound(Input) : Bound(0, 0) {}  // NOLINT: a coordinate beside an intermediate value is one without error

  // e * (1 + 2^-53), rounded up: the product with 2^-53 is less than one unit while e < 2^53.
  static constexpr std::uint64_t widened(std::uint64_t e) {
    if (e >= 1ull << 42) throw_bound_too_large();
    return e + 1;
  }

  friend constexpr Bound operator-(Input, Input) { return {eps, 0}; }
  friend constexpr Bound operator+(Input, Input) { return {eps, 0}; }
  friend constexpr Bound operator+(Bound a, Bound b) {
    const std::uint64_t larger = widened(a.e > b.e ? a.e : b.e);
    return {larger + eps, larger};
  }
  friend constexpr Bound operator-(Bound a, Bound b) { return a + b; }
  friend constexpr Bound operator*(Bound a, Bound b) {
    const std::uint64_t s = widened(a.e) + b.e;  // a + b + a * b, whose last term is below one unit while a, b < 2^42
    return {widened(widened(s) + eps), widened(widened(s))};
  }
  /// x + x, which rounds nothing: value, magnitude and error are all twice what they were.
  friend constexpr Bound twice(Bound a) { return {a.e, a.e}; }
};

}  // namespace plumb
