// What does a double become when each rounding's error is kept?  A pair of doubles, added and multiplied without
// normalizing: the usual "compensated" arithmetic.
//
// Laws: none that hold for every input; about twice the digits of a double where nothing overflows or underflows.  It
// is here to be tried, and decides nothing of ours.
// Source: Lange and Rump 2020 (pair arithmetic), Ogita, Rump and Oishi 2005.
// Cost: 8 operations a sum, 23 a product without a fused multiply-add.
#pragma once

#include <cmath>

#include "plumb/arith/error_free.hpp"

namespace plumb::tool::trial {

struct Compensated {
  double value, error;

  Compensated(double v, double e) : value(v), error(e) {}
  Compensated(double x = 0) : Compensated(x, 0) {}  // NOLINT: a double is one

  [[nodiscard]] double rounded() const { return value + error; }

  friend Compensated operator+(const Compensated& a, const Compensated& b) {
    const Rounded s = two_sum(a.value, b.value);
    return {s.value, s.error + (a.error + b.error)};
  }
  friend Compensated operator-(const Compensated& a, const Compensated& b) {
    return a + Compensated{-b.value, -b.error};
  }
  friend Compensated operator*(const Compensated& a, const Compensated& b) {
    const Rounded p = two_product(a.value, b.value);
    return {p.value, p.error + (a.value * b.error + a.error * b.value)};
  }

  // What code that branches asks besides; 36 operations a quotient.
  friend Compensated operator/(const Compensated& a, const Compensated& b) {
    const double first = a.rounded() / b.rounded();
    return {first, (a - b * Compensated(first)).rounded() / b.rounded()};
  }
  friend Compensated operator-(const Compensated& a) { return {-a.value, -a.error}; }
  friend bool operator<(const Compensated& a, const Compensated& b) { return (a - b).rounded() < 0; }
  friend bool operator>(const Compensated& a, const Compensated& b) { return b < a; }
  friend bool operator<=(const Compensated& a, const Compensated& b) { return (a - b).rounded() <= 0; }
  friend bool operator>=(const Compensated& a, const Compensated& b) { return b <= a; }
  friend bool operator==(const Compensated& a, const Compensated& b) { return (a - b).rounded() == 0; }
  friend Compensated square_root(const Compensated& x) {
    const double first = std::sqrt(x.rounded());
    if (!(first > 0)) return {first, 0};
    return {first, (x - Compensated(first) * Compensated(first)).rounded() / (2 * first)};
  }
  friend double root_as_double(const Compensated& square) { return square_root(square).rounded(); }
};

}  // namespace plumb::tool::trial
