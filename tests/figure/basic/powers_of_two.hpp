// Does the answer about two figures stay when both are taken a power of two times?  From the least doubles to the
// largest.
//
// Laws: the numbers are multiplied where no bit is lost; axes and directions, which have a scale of their own, by other
// powers.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "figure/basic/shape_cases.hpp"

namespace plumb::powers_of_two {

/// Times 2^exponent; false where that is no double.
inline bool take(double& x, int exponent) {
  const double times = std::ldexp(x, exponent);
  if (!std::isfinite(times) || std::ldexp(times, -exponent) != x) return false;
  x = times;
  return true;
}
template <class Numbers>
requires requires(Numbers v) { v.x; }
bool take(Numbers& v, int exponent) {
  bool exact = take(v.x, exponent) && take(v.y, exponent);
  if constexpr (requires { v.z; }) exact = exact && take(v.z, exponent);
  return exact;
}
template <class... Parts>
bool take_all(int exponent, Parts&... parts) {
  return (take(parts, exponent) && ...);
}

/// The figure, 2^exponent times as large; 2^other more for what has a scale of its own.
template <class Shape>
bool take_shape(Shape& s, int exponent, int other) {
  if constexpr (requires { s.axes; }) {
    return take_all(exponent, s.center) && take_all(other, s.axes[0], s.axes[1], s.axes[2]) &&
           take_all(exponent - other, s.half);
  } else if constexpr (requires { s.point; }) {
    return take_all(exponent, s.point) && take_all(other, s.direction);
  } else if constexpr (requires { s.origin; }) {
    return take_all(exponent, s.origin) && take_all(other, s.direction);
  } else if constexpr (requires { s.center; }) {
    return take_all(exponent, s.center, s.radius);
  } else if constexpr (requires { s.min; }) {
    return take_all(exponent, s.min, s.max);
  } else if constexpr (requires { s.c; }) {
    return take_all(exponent, s.a, s.b, s.c);
  } else if constexpr (requires { s.radius; }) {
    return take_all(exponent, s.a, s.b, s.radius);
  } else {
    return take_all(exponent, s.a, s.b);
  }
}

/// `relate` of many pairs, each taken several times; `least` is how many of a hundred must have kept all bits.
template <class A, class B>
void expect_same_relation(std::uint64_t start, std::uint64_t cases, int least = 30) {
  std::uint64_t taken = 0, tried = 0;
  shape_cases::on_shapes(start, cases, [&](shape_cases::Material& m) {
    const A a = m.shape<A>();
    const B b = m.shape<B>();
    const Relation r = relate(a, b);
    for (const int widest : {40, 400, 1000}) {
      const auto any = [&m](int most) { return static_cast<int>(m.entropy().within(most)); };
      const int exponent = any(widest), of_a = any(widest / 2), of_b = any(widest / 2);
      A c = a;
      B d = b;
      ++tried;
      if (!take_shape(c, exponent, of_a) || !take_shape(d, exponent, of_b)) continue;
      ++taken;
      ASSERT_EQ(relate(c, d), r) << m.about(a, b) << " times 2^" << exponent << m.about(c, d);
    }
  });
  EXPECT_GE(taken * 100, tried * static_cast<std::uint64_t>(least)) << taken << " of " << tried;
}

}  // namespace plumb::powers_of_two
