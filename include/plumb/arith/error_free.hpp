// What did one rounding lose?  Error-free transforms of a sum and a product.
//
// Laws: two_sum(a, b) returns s = fl(a + b) and the exact t with s + t = a + b, unless s overflows.
//       two_product(a, b) returns p = fl(a * b) and the exact t with p + t = a * b when 2^-960 <= |p| <= 2^960 and both
//       factors are below 2^960; outside of that t is undefined.
// Source: Knuth, TAOCP 4.2.2; Dekker 1971, Veltkamp's splitting.
// Cost: 6 and 17 operations; 2 with a hardware fma.
#pragma once

#include <type_traits>

#include "plumb/predicates/standard.hpp"

namespace plumb {

struct Rounded {
  double value, error;
};

constexpr Rounded two_sum(double a, double b) {
  const double s = a + b;
  const double b_part = s - a;
  return {s, (a - (s - b_part)) + (b - b_part)};
}

constexpr Rounded two_product(double a, double b) {
  const double p = a * b;
#ifdef __FMA__
  if (!std::is_constant_evaluated()) return {p, __builtin_fma(a, b, -p)};  // which Clang does not evaluate
#endif
  constexpr double splitter = 0x1p27 + 1;
  const double ca = splitter * a, cb = splitter * b;
  const double ah = ca - (ca - a), bh = cb - (cb - b);
  const double al = a - ah, bl = b - bh;
  return {p, al * bl - (((p - ah * bh) - al * bh) - ah * bl)};
}

}  // namespace plumb
