// Adaptive precision: is this sign certain?  Over numbers that may be too rough to tell it: plain doubles first, then
// pairs of doubles, then integers.
//
// Laws: a sign that is certain is that of the exact value; once one is not, the answers so far mean nothing.  Over
// BigDyadic every sign is.  When a number's sign is certain, the number itself knows.
// Source: docs/proof.md.
// Cost: that of the numbers.
#pragma once

#include <concepts>

#include "plumb/arith/sign.hpp"

namespace plumb {

/// a - b of two coordinates as given: rounded once, its magnitude is its own.
template <class T>
constexpr T coordinate_difference(double a, double b) {
  if constexpr (requires { T::difference(a, b); }) {
    return T::difference(a, b);
  } else {
    return T(a) - T(b);
  }
}

/// Signs, as far as they are certain; zero for one that is not.
class CertainSigns {
 public:
  template <class T>
  Sign operator()(const T& x) {
    if constexpr (requires { x.certain_sign(); }) {  // 0 is never certain there, and no branch is taken
      const int s = x.certain_sign();
      certain_ = certain_ && s != 0;
      return static_cast<Sign>(s);
    } else if constexpr (std::same_as<decltype(x.sign()), Sign>) {
      return x.sign();
    } else {
      const Unsure<Sign> s = x.sign();
      certain_ = certain_ && s.certain();
      return s.certain() ? s.value() : Sign::zero;
    }
  }
  [[nodiscard]] bool certain() const { return certain_; }

 private:
  bool certain_ = true;
};

/// -1 or 1 where the sign is certain, else 0; 0 also for what is certainly zero.
template <class T>
[[gnu::always_inline]] constexpr int certain_sign(const T& x) {
  if constexpr (requires { x.certain_sign(); }) {
    return x.certain_sign();
  } else {
    const Unsure<Sign> s = x.sign();
    return s.certain() ? static_cast<int>(s.value()) : 0;
  }
}

/// True only of what is exactly zero.
template <class T>
constexpr bool certainly_zero(const T& x) {
  if constexpr (std::same_as<decltype(x.sign()), Sign>) {
    return x.sign() == Sign::zero;
  } else if constexpr (requires { x.high, x.radius; }) {
    return x.high == 0 && x.radius == 0;
  } else if constexpr (requires { x.value, x.error; }) {
    return x.value == 0 && x.error == 0;
  } else {
    return x.sign() == Unsure{Sign::zero};
  }
}

}  // namespace plumb
