// What is the exact value, to twice the digits of a double, as fast as can be?  Two doubles and the size of the terms.
//
// Laws: |exact - (high + low)| <= error * 2^-106 * magnitude, |low| <= width * 2^-53 * magnitude and |high| <=
// magnitude: arith/filtered.hpp carried one double further.  The factors are constants of the optimizer's where the
// code is inlined.  Nothing is normalized until the end; there nearest() gives the one double that is nearest, where
// there is but one (Ziv's test).  Overflow and NaN end in nothing. Fma: the error of a product by the instruction, else
// by Dekker's splitting; the results are the same to the bound.
// Source: docs/proof.md, "Twofold"; Lange and Rump 2020 (pair arithmetic); Ziv 1991.
// Cost: 10 operations a sum, 7 or 22 a product.
#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <cmath>
#include <optional>

#include "arith/approximate.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/filtered.hpp"

namespace plumb {

template <bool Fma>
struct Twofold {
  double high, low, magnitude, error, width;

  constexpr Twofold(double h, double l, double m, double e, double w)
      : high(h), low(l), magnitude(m), error(e), width(w) {}
  constexpr explicit Twofold(double x) : Twofold(x, 0, magnitude_of(x), 0, 0) {}

  // What the text of sums and products is made of.
  using Self = Twofold;
  using Number = double;
  using Truth = bool;
  static constexpr double number(double x) { return x; }
  static constexpr double size(double x) { return magnitude_of(x); }
  static constexpr double negated(double x) { return -x; }
  static constexpr bool equal(double a, double b) { return a == b; }
  static constexpr Rounded two_sum(double a, double b) { return plumb::two_sum(a, b); }
  [[gnu::always_inline]] static inline double plus_product(double c, double a, double b) {
    if constexpr (Fma) {
      return __builtin_fma(a, b, c);
    } else {
      return c + a * b;
    }
  }
  [[gnu::always_inline]] static inline Rounded product(double a, double b) {
    if constexpr (Fma) {
      const double p = a * b;
      return {p, __builtin_fma(a, b, -p)};
    } else {
      return two_product(a, b);
    }
  }
#define PLUMB_TWOFOLD_INLINE inline __attribute__((always_inline))
#include "arith/twofold_text.hpp"
#undef PLUMB_TWOFOLD_INLINE

  /// a - q b, rounded, where that is near zero.
  [[gnu::always_inline]] static inline double lacking(double a, double q, double b) {
    if constexpr (Fma) {
      return __builtin_fma(-q, b, a);
    } else {
      const Rounded p = product(q, b);
      return (a - p.value) - p.error;
    }
  }
  /// In one instruction: the library's would be called for the sake of errno.
  [[gnu::always_inline]] static inline double square_root(double x) {
#ifdef __SSE2__
    const __m128d both = _mm_set1_pd(x);
    return _mm_cvtsd_f64(_mm_sqrt_sd(both, both));
#else
    return std::sqrt(x);
#endif
  }

  /// a / b; of infinite reach where b may be zero or its digits are too uncertain.  Nothing of its magnitude waits
  /// for r.
  [[gnu::always_inline]] friend inline Twofold quotient(const Twofold& a, const Twofold& b) {
    const double inverse = 1 / (b.high + b.low), share = magnitude_of(inverse);
    const bool sure = b.error * unit * b.magnitude * share < 0x1p-10 && share > 0x1p-1000;
    const double q = a.high * inverse, r = (lacking(a.high, q, b.high) + (a.low - q * b.low)) * inverse;
    const double terms = a.magnitude + plus_product(guard, magnitude_of(q), b.magnitude);
    const double w = (a.width + 2 * b.width + 4) * (1 + slack), e = larger(a.error, b.error) + 10 * w;
    return {q, r, plus_product(guard, sure ? share : Ball::infinity, terms), e * (1 + 8 * slack), w * (1 + slack)};
  }

  /// The square root; of infinite reach where a may be zero or below, or so small that digits are lost.
  [[gnu::always_inline]] friend inline Twofold root(const Twofold& a) {
    const Rounded x = two_sum(a.high, a.low);
    const double q = square_root(x.value), half = 0.5 / q, r = (lacking(x.value, q, q) + x.error) * half;
    const bool sure = x.value > 0x1p-900 && a.error * unit * unit * a.magnitude < x.value * 0x1p-10;
    return {q, r, (sure ? 2 * half : Ball::infinity) * a.magnitude * (1 + slack), (a.error + 8) * (1 + 8 * slack),
            2 + slack};
  }

  // The same by high parts alone, which do not wait for the low ones: for a divisor or radicand that is not much
  // smaller than its terms, for the error grows with the square of that ratio.
  [[gnu::always_inline]] friend inline Twofold quotient_at_once(const Twofold& a, const Twofold& b) {
    const double inverse = 1 / b.high, share = magnitude_of(inverse), condition = b.magnitude * share;
    const bool sure = b.width * unit * condition < 0x1p-10 && share > 0x1p-1000;
    const double factor = sure ? share * (1 + condition) : Ball::infinity;
    const double q = a.high * inverse, r = (lacking(a.high, q, b.high) + (a.low - q * b.low)) * inverse;
    const double terms = a.magnitude + plus_product(guard, magnitude_of(q), b.magnitude);
    const double w = (a.width + b.width + 3) * (1 + slack), e = larger(a.error, b.error) + 9 * w;
    return {q, r, plus_product(guard, factor, terms), larger(e, 3 * w * b.width) * (1 + 8 * slack), w * (1 + slack)};
  }
  [[gnu::always_inline]] friend inline Twofold root_at_once(const Twofold& a) {
    const double q = square_root(a.high), half = 0.5 / q, w = (a.width + 3) * (1 + slack);
    const bool sure = a.high > 0x1p-900 && w * unit * a.magnitude < a.high * 0x1p-10;
    const double r = (lacking(a.high, q, q) + a.low) * half, share = sure ? 2 * half : Ball::infinity;
    const double condition = a.magnitude * share * share;
    return {q, r, share * a.magnitude * (1 + condition), larger(a.error + 6 * w, w * w) * (1 + 8 * slack),
            w * (1 + slack)};
  }

  // The same of a sum of squares, which is its own magnitude but for a part of 2^-9 of it, where it is not tiny.
  [[gnu::always_inline]] friend inline Twofold quotient_by_squares(const Twofold& a, const Twofold& b) {
    const double inverse = 1 / b.high, q = a.high * inverse;
    const double r = (lacking(a.high, q, b.high) + (a.low - q * b.low)) * inverse;
    const bool sure = b.width * unit < 0x1p-12 && b.high > 0x1p-900 && inverse > 0x1p-1000;
    const double factor = sure ? (4 + 0x1p-4) * inverse : Ball::infinity;
    const double w = (a.width + b.width + 3) * (1 + slack), e = larger(a.error, b.error) + 9 * w;
    return {q, r, plus_product(guard, factor, a.magnitude + guard), larger(e, 3 * w * b.width) * (1 + 8 * slack),
            w * (1 + slack)};
  }
  [[gnu::always_inline]] friend inline Twofold root_of_squares(const Twofold& a) {
    const double q = square_root(a.high), w = (a.width + 3) * (1 + slack);
    const double r = (lacking(a.high, q, q) + a.low) * (0.5 / q);
    const double most = a.high > 0x1p-900 && w * unit < 0x1p-12 ? 2 + 0x1p-6 : Ball::infinity;
    return {q, r, most * q, larger(a.error + 6 * w, w * w) * (1 + 8 * slack), w * (1 + slack)};
  }

  /// The same with this error and the width of a sum of two: its own size is the magnitude, where the terms were not so
  /// much larger that the error is greater than that.
  [[nodiscard]] [[gnu::always_inline]] inline Twofold renewed(double to_error) const {
    const Rounded s = two_sum(high, low);
    const double needed = plus_product(guard, error * (1 + slack) / to_error, magnitude);
    return {s.value, s.error, larger(magnitude_of(s.value), needed), to_error, 1};
  }

  /// The high part alone.
  [[nodiscard]] constexpr Approximate plain() const { return {high, magnitude, width + error * 0x1p-50}; }

  /// The sign where it is certain, which it never is of zero, else 0.
  [[nodiscard]] int certain_sign() const {
    const double most = reach() * (1 + slack), sum = high + low;
    return static_cast<int>(sum > most) - static_cast<int>(sum < -most);
  }

  /// Of infinite radius where nothing is known.
  [[nodiscard]] Ball ball() const {
    const Rounded s = two_sum(high, low);
    const double off = reach();
    const bool known = off < Ball::infinity && magnitude_of(s.value) < 0x1p1000;
    return {s.value, s.error, !known ? Ball::infinity : error == 0 ? 0 : off};
  }
  [[nodiscard]] std::optional<double> nearest() const { return ball().nearest(); }
};

}  // namespace plumb
