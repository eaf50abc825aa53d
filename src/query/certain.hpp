// What do plain doubles prove?  A number that carries how far it may be off, and the signs that are certain of it.
//
// Laws: (1) |value - exact| <= error * 2^-53 * magnitude, and |value| <= magnitude: the filter of arith/filtered.hpp
// with the constant carried along instead of derived from a formula, so that any code over + - * can be asked.  Of code
// that is inlined the error is a constant of the optimizer's.  (2) A sign that is certain is that of the exact value;
// overflow and NaN end as uncertain.  (3) Over Ball and BigDyadic the same code gives more, and all.
// Source: docs/proof.md, "Filter A".  Cost: about one more operation for each operation.
#pragma once

#include "plumb/arith/ball.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/filtered.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb::query {

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
};

/// a - b of two coordinates as given: rounded once, its magnitude is its own.
template <class T>
constexpr T coordinate_difference(double a, double b) {
  if constexpr (std::is_same_v<T, Approximate>) {
    return {a - b, magnitude_of(a - b), 1};
  } else {
    return T(a) - T(b);
  }
}

/// Signs, as far as they are certain: once one is not, the answers so far mean nothing.
class Signs {
 public:
  Sign operator()(const Approximate& x) {
    const double most = (x.error + Approximate::slack) * 0x1p-53 * x.magnitude;
    const int s = static_cast<int>(x.value > most) - static_cast<int>(x.value < -most);
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
  Sign operator()(const BigDyadic& x) { return x.sign(); }

  [[nodiscard]] bool certain() const { return certain_; }

 private:
  bool certain_ = true;
};

}  // namespace plumb::query
