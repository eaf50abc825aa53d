// Double-double: numbers of twice the digits of a double, for guesses that doubles are too coarse for.  A guess, which holds no
// bound; arith/twofold.hpp has the numbers that know their errors.
//
// Laws: the same on every machine: products are split by Dekker's method.
// Source: Dekker 1971; Hida, Li and Bailey 2001.
// Cost: some 12 operations a sum, 25 a product.
#pragma once

#include "plumb/arith/error_free.hpp"

namespace plumb::arith {

struct DoubleDouble {
  double high = 0, low = 0;

  constexpr DoubleDouble() = default;
  constexpr explicit DoubleDouble(double x) : high(x) {}
  static constexpr DoubleDouble of(double high, double low) {
    const Rounded s = two_sum(high, low);
    DoubleDouble r(s.value);
    r.low = s.error;
    return r;
  }

  friend constexpr DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const Rounded s = two_sum(a.high, b.high);
    return of(s.value, s.error + (a.low + b.low));
  }
  friend constexpr DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
    DoubleDouble back(-b.high);
    back.low = -b.low;
    return a + back;
  }
  friend constexpr DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const Rounded p = two_product(a.high, b.high);
    return of(p.value, p.error + (a.high * b.low + a.low * b.high));
  }
  friend constexpr bool operator<(const DoubleDouble& a, const DoubleDouble& b) { return (a - b).high < 0; }
  friend constexpr bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
  friend constexpr bool operator<=(const DoubleDouble& a, const DoubleDouble& b) { return !(b < a); }
};

}  // namespace plumb::arith
