// What is the exact value, to twice the digits of a double, as fast as can be?  Two doubles and the size of the terms.
//
// Laws: |exact - (high + low)| <= error * 2^-106 * magnitude, |low| <= width * 2^-53 * magnitude and |high| <=
// magnitude: arith/filtered.hpp carried one double further.  The factors are constants of the optimizer's where the
// code is inlined.  Nothing is normalized until the end; there nearest() gives the one double that is nearest, where
// there is but one (Ziv's test).  Overflow and NaN end in nothing. Fma: the error of a product by the instruction, else
// by Dekker's splitting; the results are the same to the bound.
// Source: docs/proof.md, "Twofold"; Lange and Rump 2020 (pair arithmetic); Ziv 1991.
// Cost: 10 operations a sum, 8 or 22 a product.
#pragma once

#include <cmath>
#include <optional>

#include "plumb/arith/ball.hpp"
#include "plumb/arith/filtered.hpp"

namespace plumb {

template <bool Fma>
struct Twofold {
  double high, low, magnitude, error, width;

  static constexpr double slack = 0x1p-10, guard = 0x1p-960, unit = 0x1p-53;

  constexpr Twofold(double h, double l, double m, double e, double w)
      : high(h), low(l), magnitude(m), error(e), width(w) {}
  constexpr explicit Twofold(double x) : Twofold(x, 0, magnitude_of(x), 0, 0) {}

  /// a - b of two coordinates as given: exact.
  static Twofold difference(double a, double b) {
    const Rounded d = two_sum(a, -b);
    return {d.value, d.error, magnitude_of(d.value), 0, 1};
  }

  static constexpr double larger(double a, double b) { return a > b ? a : b; }
  [[gnu::always_inline]] static inline Rounded product(double a, double b) {
    if constexpr (Fma) {
      const double p = a * b;
      return {p, __builtin_fma(a, b, -p)};
    } else {
      return two_product(a, b);
    }
  }

  [[gnu::always_inline]] friend inline Twofold operator+(const Twofold& a, const Twofold& b) {
    const Rounded s = two_sum(a.high, b.high);
    const double w = larger(a.width, b.width);
    return {s.value, s.error + (a.low + b.low), a.magnitude + b.magnitude,
            larger(a.error, b.error) + (2 * w + 1 + slack), w + (1 + slack)};
  }
  [[gnu::always_inline]] friend inline Twofold operator-(const Twofold& a, const Twofold& b) {
    return a + Twofold{-b.high, -b.low, b.magnitude, b.error, b.width};
  }
  [[gnu::always_inline]] friend inline Twofold operator*(const Twofold& a, const Twofold& b) {
    const Rounded p = product(a.high, b.high);
    const double w = a.width + b.width;
    return {p.value, p.error + (a.high * b.low + a.low * b.high), a.magnitude * b.magnitude + guard,
            a.error + b.error + a.width * b.width + 4 * w + (1 + slack), w + (1 + slack)};
  }

  /// The bound of the error as a number; infinite or NaN where nothing is known.
  [[nodiscard]] double reach() const { return error * (1 + slack) * 0x1p-106 * magnitude; }

  /// A value of this error.
  [[gnu::always_inline]] static inline Twofold within(double h, double l, double reach) {
    constexpr double units = 64;
    const double of_low = magnitude_of(l) * 0x1p53, of_error = reach * (0x1p106 / units);
    return {h, l, (magnitude_of(h) + of_low) + of_error, units, 1 + slack};
  }

  /// a / b; of infinite reach where b may be zero or its digits are too uncertain.
  [[gnu::always_inline]] friend inline Twofold quotient(const Twofold& a, const Twofold& b) {
    const double size = magnitude_of(b.high), off = b.width * unit * b.magnitude;  // of b.high, less than twice that
    const double q = a.high / b.high;
    const Twofold rest = a - Twofold{q} * b;
    const double left = rest.high + rest.low, r = left / b.high;
    // What is left after r is no more than the error of the rest, the rounding of r, be it subnormal, and what comes of
    // dividing by b.high instead of b, which are apart by no more than twice `off`.
    const double reach =
        (rest.reach() + magnitude_of(left) * (0x1p-50 + 4 * off / size)) / size * (1 + 0x1p-6) + 0x1p-1070;
    const bool sure = size > 0x1p-900 && off < size * 0x1p-10;
    return within(q, r, sure ? reach : Ball::infinity);
  }

  /// The square root; of infinite reach where a may be zero or below, or so small that digits are lost.
  [[gnu::always_inline]] friend inline Twofold root(const Twofold& a) {
    const double q = std::sqrt(a.high);
    const Rounded p = product(q, q);
    const double of_high = (a.high - p.value) - p.error, left = of_high + a.low, r = left / (2 * q);
    // sqrt(a) - q = (a - q^2) / (sqrt(a) + q): off by |r| / 2q of itself from r, and by the errors of what is left.
    const double rounded = (magnitude_of(of_high) + magnitude_of(a.low)) * 0x1p-50;
    const double reach = (a.reach() + rounded + magnitude_of(left) * (2 * magnitude_of(r) / q)) / q * (1 + 0x1p-6);
    const bool sure = a.high > 0x1p-900 && magnitude_of(r) < q * 0x1p-10 && a.reach() < a.high * 0x1p-10;
    return within(q, r, sure ? reach : Ball::infinity);
  }

  /// The sign where it is certain, which it never is of zero, else 0.
  [[nodiscard]] int certain_sign() const {
    const double most = reach() * (1 + slack), sum = high + low;
    return static_cast<int>(sum > most) - static_cast<int>(sum < -most);
  }

  [[nodiscard]] std::optional<double> nearest() const {
    const Rounded s = two_sum(high, low);
    const double off = reach();
    if (!(off < Ball::infinity) || !(magnitude_of(s.value) < 0x1p1000)) return {};
    return Ball{s.value, s.error, error == 0 ? 0 : off}.nearest();
  }
};

}  // namespace plumb
