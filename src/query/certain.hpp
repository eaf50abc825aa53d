// Exact predicates, adaptive precision: signs over numbers that may be too rough to tell them: plain doubles first,
// then pairs of doubles, then integers.
//
// Laws: a sign that is certain is that of the exact value; once one is not, the answers so far mean nothing.  Over
// BigDyadic every sign is.
// Source: docs/proof.md.
// Cost: that of the numbers.
#pragma once

#include "plumb/arith/approximate.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/twofold.hpp"

namespace plumb::query {

/// a - b of two coordinates as given: rounded once, its magnitude is its own.
template <class T>
constexpr T coordinate_difference(double a, double b) {
  if constexpr (requires { T::difference(a, b); }) {
    return T::difference(a, b);
  } else {
    return T(a) - T(b);
  }
}

/// Signs, as far as they are certain.
class Signs {
 public:
  Sign operator()(const Approximate& x) {
    const int s = x.certain_sign();
    certain_ = certain_ && s != 0;
    return static_cast<Sign>(s);
  }
  Sign operator()(const Ball& x) {
    // |low| is at most half an ulp of high: the sum has the sign of high, and is no less than half of it.
    if (x.radius == 0) return sign_of_number(x.high);
    const bool far = magnitude_of(x.high) * 0.5 > x.radius;
    certain_ = certain_ && far;
    return far ? sign_of_number(x.high) : Sign::zero;
  }
  template <bool Fma>
  Sign operator()(const Twofold<Fma>& x) {
    const double most = x.reach() * (1 + Twofold<Fma>::slack), sum = x.high + x.low;
    const int s = static_cast<int>(sum > most) - static_cast<int>(sum < -most);
    certain_ = certain_ && s != 0;
    return static_cast<Sign>(s);
  }
  Sign operator()(const BigDyadic& x) { return x.sign(); }

  [[nodiscard]] bool certain() const { return certain_; }

 private:
  bool certain_ = true;
};

}  // namespace plumb::query
