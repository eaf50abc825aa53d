// What does a double become when each rounding's error is kept?  A pair of doubles, added and multiplied without
// normalizing: the usual "compensated" arithmetic.
//
// Laws: none that hold for every input; about twice the digits of a double where nothing overflows or underflows.  It
// is here to be tried, and decides nothing of ours.
// Source: Lange and Rump 2020 (pair arithmetic), Ogita, Rump and Oishi 2005; cost: 8 operations a sum, 23 a product
// without a fused multiply-add.
#pragma once

#include "plumb/arith/error_free.hpp"

namespace plumb::tool::trial {

struct Compensated {
  double value, error;

  Compensated(double v, double e) : value(v), error(e) {}
  explicit Compensated(double x) : Compensated(x, 0) {}

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
};

}  // namespace plumb::tool::trial
