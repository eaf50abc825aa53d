// Ball arithmetic: what is the exact value, to some hundred bits?  A pair of doubles and how far from it the value can
// be.
//
// Laws: |exact - (high + low)| <= radius, and high is the double nearest to high + low.  What is computed without error
// has radius 0: small integers stay exact.  Where the error-free transforms do not hold (beyond 2^960 or below 2^-960)
// the radius is infinite: nothing is claimed there. nearest() gives the double nearest to the exact value when only one
// can be (Ziv's test); else nothing.
// Source: Dekker 1971; Ziv 1991.  RTCD 11.4.
// Cost: 20 operations a sum, 40 a product, 150 a quotient or root.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <optional>

#include "plumb/arith/error_free.hpp"
#include "plumb/arith/rounding.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

struct Ball {
  double high, low, radius;

  constexpr Ball(double h, double l, double r) : high(h), low(l), radius(r) {}
  constexpr explicit Ball(double x) : Ball(x, 0, 0) {}

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double size(double x) { return __builtin_fabs(x); }
  // The double above (1) or below (-1).
  static constexpr double next(double x, int way) {
    if (x == 0) return way * std::numeric_limits<double>::denorm_min();
    const auto pattern = std::bit_cast<std::uint64_t>(x);
    return std::bit_cast<double>((x > 0) == (way > 0) ? pattern + 1 : pattern - 1);
  }
  // What the text of sums and products is made of.
  using Self = Ball;
  using Number = double;
  using Truth = bool;
  static constexpr double number(double x) { return x; }
  static constexpr double negated(double x) { return -x; }
  static constexpr bool at_most(double a, double b) { return a <= b; }
  static constexpr bool above(double a, double b) { return a > b; }
  static constexpr bool is_zero(double x) { return x == 0; }
  static constexpr bool both(bool a, bool b) { return a && b; }
  static constexpr bool either(bool a, bool b) { return a || b; }
  static constexpr double chosen(bool first, double a, double b) { return first ? a : b; }
#define PLUMB_BALL_INLINE constexpr
#include "plumb/arith/detail/ball_text.hpp"
#undef PLUMB_BALL_INLINE

  friend constexpr Ball magnitude(const Ball& x) { return x.high < 0 ? Ball{-x.high, -x.low, x.radius} : x; }

  /// a / b; of infinite radius where b may be zero.
  friend constexpr Ball quotient(const Ball& a, const Ball& b) {
    if (!(size(b.high) > 0x1p-960 && b.radius < size(b.high) * 0x1p-10)) return {0, 0, infinity};
    const double least = size(b.high) * (1 - 0x1p-9);  // of |b|
    const double q = a.high / b.high;
    const Ball rest = a - Ball{q} * b;
    const double r = rest.high / b.high;
    const Ball last = rest - Ball{r} * b;
    const double left = size(last.high) + size(last.low) + last.radius;
    const Rounded s = two_sum(q, r);
    return {s.value, s.error, left == 0 ? 0 : widened(left / least) + 0x1p-1060};
  }

  /// The square root; of infinite radius where a may be zero or below, except for zero itself.
  friend Ball root(const Ball& a) {
    if (a.high == 0 && a.low == 0 && a.radius == 0) return a;
    if (!(a.high > 0x1p-900 && a.high < 0x1p900 && a.radius < a.high * 0x1p-10)) return {0, 0, infinity};
    const double q = __builtin_sqrt(a.high);
    const Ball rest = a - Ball{q} * Ball{q};
    const double r = rest.high / (2 * q);
    const Ball s = Ball{q} + Ball{r};
    const Ball last = a - s * s;  // the root is off by |last| / (s + root), and both are at least q (1 - 2^-9)
    const double left = size(last.high) + size(last.low) + last.radius;
    return {s.high, s.low, left == 0 ? 0 : widened(left / q) + 0x1p-1060};
  }

  /// The sign, where it is certain: |low| is at most half an ulp of high, so the exact value is beyond zero where half
  /// of high is beyond the radius.
  [[nodiscard]] constexpr Unsure<Sign> sign() const {
    if (radius == 0 || size(high) * 0.5 > radius) return Unsure{sign_of_number(high)};
    return {};
  }

  /// The exact value rounded as asked, where that is certain.  Never -0.
  [[nodiscard]] constexpr std::optional<double> rounded(Rounding rounding) const {
    if (rounding == Rounding::nearest) return nearest();
    if (!(size(high) < 0x1p1022 && radius < infinity)) return {};
    const double reach = radius == 0 ? 0 : radius * (1 + 0x1p-20) + size(low) * 0x1p-50 + 0x1p-1074;
    const double from = low - reach, to = low + reach;  // off high; both within an ulp of it, or nothing is certain
    const bool exact = from == 0 && to == 0;
    if (!exact && !(from > 0 || to < 0)) return {};
    const double neighbor = next(high, from > 0 ? 1 : -1);
    if (!exact && !(size(from) < size(neighbor - high) && size(to) < size(neighbor - high))) return {};
    if (exact || (from > 0) == (rounding == Rounding::down)) return high + 0.0;
    return neighbor + 0.0;
  }

  /// The double nearest to the exact value, ties to even, where that is certain.  Never -0.
  [[nodiscard]] constexpr std::optional<double> nearest() const {
    if (!(size(high) < infinity && radius < infinity)) return {};
    if (radius == 0) return high + 0.0;
    const double reach = radius * (1 + 0x1p-20) + size(low) * 0x1p-50 + 0x1p-1074;
    const double from = high + (low - reach), to = high + (low + reach);
    if (from != to || !(size(from) < infinity)) return {};
    return from + 0.0;
  }
};

}  // namespace plumb
