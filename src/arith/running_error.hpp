// How far off can this double be?  A value beside a bound of its error, both carried through a computation.
//
// Laws: |exact - value| <= error (1 + 2^-39), after up to 2^11 operations in a row: each rounds the bound down by less
// than 2^-50 of it, and sign() makes up for it.  A difference of equal doubles is certainly zero; overflow and NaN end
// in a bound that nothing exceeds.
// Source: Wilkinson 1986 (running error analysis).
// Cost: about three times the plain operations; of a quotient twice.
#pragma once

#include "plumb/arith/sign.hpp"

namespace plumb {

struct Running {
  double value, error;

  constexpr Running() : value(0), error(0) {}
  constexpr Running(double v, double e) : value(v), error(e) {}
  constexpr explicit Running(double x) : value(x), error(0) {}

  // Half an ulp of a result is at most `unit` of it; the guard pays for all underflow of a product.
  static constexpr double unit = 0x1p-53, guard = 0x1p-1000;
  static constexpr double size(double x) { return __builtin_fabs(x); }
  /// What was off by so much before it was rounded to v, as what doubles judge is (certify/world.hpp).
  static constexpr Running rounded(double v, double off) { return {v, off + size(v) * unit}; }

  friend constexpr Running operator+(Running a, Running b) {
    const double v = a.value + b.value;
    return {v, (a.error + b.error) + size(v) * unit};
  }
  friend constexpr Running operator-(Running a, Running b) { return a + Running{-b.value, b.error}; }
  friend constexpr Running operator*(Running a, Running b) {
    const double v = a.value * b.value;
    const double inherited = (size(a.value) + a.error) * b.error + size(b.value) * a.error;
    return {v, inherited + (size(v) * unit + guard)};
  }
  /// a / b; of infinite error where b may be zero.  With errors s and t, (a + s) / (b + t) is off a / b by
  /// (s - (a / b) t) / (b + t); the least double pays for the underflow of what is divided.
  friend constexpr Running quotient(Running a, Running b) {
    const double v = a.value / b.value, least = size(b.value) - b.error * slack;
    const double inherited = a.error + (size(v) * b.error + (b.error > 0 ? 0x1p-1073 : 0));
    const double rounded = size(v) * unit + guard;
    return {v, least > 0 ? (inherited > 0 ? inherited / least : 0) + rounded : __builtin_huge_val()};
  }
  /// Clearing the sign is exact.
  friend constexpr Running magnitude(Running a) { return {size(a.value), a.error}; }

  /// No more, and no less, than the exact value; infinite where nothing is known.
  [[nodiscard]] constexpr double lower() const { return -Running{-value, error}.upper(); }
  [[nodiscard]] constexpr double upper() const {
    const double most = value + reach();
    return most == most ? most : __builtin_huge_val();
  }

  /// No less than |exact - value|.
  [[nodiscard]] constexpr double bound() const { return error * slack; }

  [[nodiscard]] constexpr Unsure<Sign> sign() const {
    const double e = bound();
    if (value > e) return Unsure{Sign::positive};
    if (value < -e) return Unsure{Sign::negative};
    if (value == 0 && error == 0) return Unsure{Sign::zero};
    return {};
  }

 private:
  static constexpr double slack = 1 + 0x1p-39;
  [[nodiscard]] constexpr double reach() const { return bound() + size(value) * 0x1p-52; }
};

}  // namespace plumb
