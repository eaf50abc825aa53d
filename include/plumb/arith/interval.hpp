// Between which doubles does the exact value lie?  Interval arithmetic without touching the rounding mode.
//
// Laws: [lower, upper] contains the exact value of every operation on contained values; an operation whose result is a
// double is not widened, so exact zeros stay [0, 0]; no bound is ever NaN (overflow widens to infinity).
// A bound moves outward only when the error-free transform says that it was rounded inward; then by 2 ulps at most.
// Source: RTCD 11.4; Rump, Ogita, Oishi 2009 for the step without nextafter.
// Cost: 30 to 150 times the plain formula.
#pragma once

#include <limits>

#include "plumb/arith/error_free.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

struct Interval {
  double lower, upper;

  constexpr Interval(double l, double u) : lower(l), upper(u) {}
  constexpr explicit Interval(double x) : Interval(x, x) {}

  /// The sign that all contained numbers share, if they share one.
  [[nodiscard]] constexpr Unsure<Sign> sign() const {
    if (lower > 0) return Unsure{Sign::positive};
    if (upper < 0) return Unsure{Sign::negative};
    if (lower == 0 && upper == 0) return Unsure{Sign::zero};
    return {};
  }

  // A double at most x (at least x) by no more than 2 ulps: the step is at least ulp(x) / 2 in every binade.
  static constexpr double part_of_step = 0x1.0000000000001p-53, least_step = 0x1p-1074;
  static constexpr double step(double x) { return __builtin_fabs(x) * part_of_step + least_step; }
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // Bounds of a rounded result x whose exact value is x + error; anything but a finite x says nothing.
  static constexpr double down(double x, double error) {
    if (!(__builtin_fabs(x) < infinity)) return -infinity;
    return error >= 0 ? x : x - step(x);
  }
  static constexpr double up(double x, double error) { return -down(-x, -error); }

  static constexpr double sum_down(double a, double b) {
    const Rounded s = two_sum(a, b);
    const bool transform_is_exact = __builtin_fabs(s.value) <= 0x1p1022;  // its inner differences cannot overflow then
    return down(s.value, transform_is_exact ? s.error : -1);
  }
  static constexpr double sum_up(double a, double b) { return -sum_down(-a, -b); }

  static constexpr double product_down(double a, double b) {
    if (a == 0 || b == 0) return 0;  // also for an infinite bound: it stands for a finite number beyond all doubles
    const double p = a * b;
    const bool transform_is_exact = __builtin_fabs(p) > 0x1p-960 && __builtin_fabs(p) < 0x1p960 &&
                                    __builtin_fabs(a) < 0x1p960 && __builtin_fabs(b) < 0x1p960;
    return down(p, transform_is_exact ? two_product(a, b).error : -1);
  }
  static constexpr double product_up(double a, double b) { return -product_down(-a, b); }

  friend constexpr Interval operator+(Interval a, Interval b) {
    return {sum_down(a.lower, b.lower), sum_up(a.upper, b.upper)};
  }
  friend constexpr Interval operator-(Interval a, Interval b) { return a + Interval{-b.upper, -b.lower}; }

  // The signs of the bounds say which products are the extremes (nine cases; both straddling zero needs four products).
  friend constexpr Interval operator*(Interval a, Interval b) {
    if (a.lower >= 0) {
      const double for_lower = b.lower >= 0 ? a.lower : a.upper;
      const double for_upper = b.upper >= 0 ? a.upper : a.lower;
      return {product_down(for_lower, b.lower), product_up(for_upper, b.upper)};
    }
    if (a.upper <= 0) {
      const double for_lower = b.upper >= 0 ? a.lower : a.upper;
      const double for_upper = b.lower >= 0 ? a.upper : a.lower;
      return {product_down(for_lower, b.upper), product_up(for_upper, b.lower)};
    }
    if (b.lower >= 0) return {product_down(a.lower, b.upper), product_up(a.upper, b.upper)};
    if (b.upper <= 0) return {product_down(a.upper, b.lower), product_up(a.lower, b.lower)};
    const double l1 = product_down(a.lower, b.upper), l2 = product_down(a.upper, b.lower);
    const double u1 = product_up(a.lower, b.lower), u2 = product_up(a.upper, b.upper);
    return {l1 < l2 ? l1 : l2, u1 > u2 ? u1 : u2};
  }

  static constexpr double quotient_down(double a, double b) {
    const double q = a / b;
    const Rounded p = two_product(q, b);  // holds for moderate factors
    const auto moderate = [](double x) { return __builtin_fabs(x) > 0x1p-900 && __builtin_fabs(x) < 0x1p900; };
    const bool exact = a == 0 || (moderate(a) && moderate(b) && moderate(q) && p.value == a && p.error == 0);
    return down(q, exact ? 0 : -1);
  }

  /// a / b; everything where b may be zero.
  friend constexpr Interval quotient(Interval a, Interval b) {
    if (b.lower <= 0 && b.upper >= 0) return {-infinity, infinity};
    if (b.upper < 0) return quotient(Interval{-a.upper, -a.lower}, Interval{-b.upper, -b.lower});
    return {quotient_down(a.lower, a.lower >= 0 ? b.upper : b.lower),
            -quotient_down(-a.upper, a.upper <= 0 ? b.upper : b.lower)};
  }

  /// The square root of what of a is not negative.
  friend Interval root(Interval a) {
    const auto inexact = [](double r, double x) {
      return x != 0 && !(r > 0x1p-450 && r < 0x1p450 && r * r == x && two_product(r, r).error == 0);
    };
    const double l = a.lower > 0 ? __builtin_sqrt(a.lower) : 0, u = a.upper > 0 ? __builtin_sqrt(a.upper) : 0;
    const double below = inexact(l, a.lower > 0 ? a.lower : 0) ? l - step(l) : l;
    return {below > 0 ? below : 0, inexact(u, a.upper > 0 ? a.upper : 0) && u < infinity ? u + step(u) : u};
  }
};

}  // namespace plumb
