// What do plain doubles prove?  A value beside its magnitude, and a factor that says how far off it may be.
//
// Laws: |value - exact| <= error * 2^-53 * magnitude, and |value| <= magnitude: the filter of arith/filtered.hpp with
// its constant carried along instead of derived from a formula, so that any code over + - * can be asked.  Of code that
// is inlined the factor is a constant of the optimizer's.  Overflow and NaN end in a magnitude that nothing exceeds.
// Source: docs/proof.md, "Filter A".
// Cost: about one more operation for each operation.
#pragma once

#include "plumb/arith/filtered.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

struct Approximate {
  double value, magnitude, error;  // the error in units of 2^-53

  // Pays for products of two errors and for the roundings of the bound, below 2^10 operations deep.
  static constexpr double slack = 0x1p-20;

  constexpr Approximate(double v, double m, double e) : value(v), magnitude(m), error(e) {}
  constexpr explicit Approximate(double x) : Approximate(x, magnitude_of(x), 0) {}

  static constexpr double larger(double a, double b) { return a > b ? a : b; }

  friend constexpr Approximate operator+(const Approximate& a, const Approximate& b) {
    return {a.value + b.value, a.magnitude + b.magnitude, larger(a.error, b.error) + (1 + slack)};
  }
  friend constexpr Approximate operator-(const Approximate& a, const Approximate& b) {
    return {a.value - b.value, a.magnitude + b.magnitude, larger(a.error, b.error) + (1 + slack)};
  }
  friend constexpr Approximate operator*(const Approximate& a, const Approximate& b) {
    return {a.value * b.value, a.magnitude * b.magnitude + underflow_guard, a.error + b.error + (1 + slack)};
  }

  constexpr Approximate operator-() const { return {-value, magnitude, error}; }

  /// | |v| - |V| | <= |v - V|, so the error stays.
  friend constexpr Approximate magnitude(const Approximate& a) { return {magnitude_of(a.value), a.magnitude, a.error}; }

  /// a - b of two coordinates as given: rounded once, its magnitude is its own.
  static constexpr Approximate difference(double a, double b) { return {a - b, magnitude_of(a - b), 1}; }

  /// The same where more is known of the terms' size: m is at least the magnitude, but for parts of 2^-11.
  [[nodiscard]] constexpr Approximate below(double m) const { return {value, m, error * (1 + 0x1p-10)}; }

  /// No less than |value - exact|.
  [[nodiscard]] constexpr double reach() const { return (error + slack) * 0x1p-53 * magnitude; }

  /// The sign where it is certain, which it never is of zero, else 0.  Without a branch on the sign, which cannot be
  /// predicted.
  [[nodiscard]] constexpr int certain_sign() const {
    const double most = reach();
    return static_cast<int>(value > most) - static_cast<int>(value < -most);
  }
  [[nodiscard]] constexpr bool certainly_positive() const { return value > reach(); }
  [[nodiscard]] constexpr bool certainly_negative() const { return value < -reach(); }
  [[nodiscard]] constexpr Unsure<Sign> sign() const {
    const int s = certain_sign();
    return s == 0 ? Unsure<Sign>{} : Unsure{static_cast<Sign>(s)};
  }
};

}  // namespace plumb
