// What are the leading digits of an exact number?  As a pair of doubles that knows how far it is off.
//
// Laws: those of plumb/arith/ball.hpp; what is left out is less than a unit of the words that are kept.  Of numbers beyond
// 2^900 or below 2^-900 nothing is told.
// Source: none; three words of the number as six halves, which are doubles each.
// Cost: some 150 operations.
#pragma once

#include <cmath>

#include "plumb/arith/ball.hpp"
#include "plumb/arith/stack_dyadic.hpp"

namespace plumb::arith {

inline Ball leading_digits(const StackDyadic& x) {
  const auto limbs = x.limbs();
  const std::size_t n = limbs.size(), first = n > 3 ? n - 3 : 0;
  const int unit = x.exponent() + 64 * static_cast<int>(first), most = x.exponent() + 64 * static_cast<int>(n);
  if (n == 0) return Ball(0.0);
  if (unit < -900 || most > 900) return {0, 0, Ball::infinity};
  Ball sum(0.0);
  for (std::size_t i = n; i-- > first;) {
    const int power = unit + 64 * static_cast<int>(i - first);
    sum = sum + Ball(std::ldexp(static_cast<double>(limbs[i] >> 32), power + 32));
    sum = sum + Ball(std::ldexp(static_cast<double>(limbs[i] & 0xffffffff), power));
  }
  if (first > 0) sum = sum + Ball{0, 0, std::ldexp(1.0, unit)};
  return x.sign() == Sign::negative ? Ball(0.0) - sum : sum;
}

}  // namespace plumb::arith
