// How large is it?  By GMP: rationals where the value is one, floats of many digits where roots and pi come in.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "figure/basic/rational_polygon.hpp"
#include "plumb/arith/point.hpp"

namespace plumb_test {

using V3 = std::array<mpq_class, 3>;

template <class V>
V3 exact3(const V& v) {
  return {mpq_class(v.x), mpq_class(v.y), mpq_class(v.z)};
}
inline V3 minus(const V3& a, const V3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline V3 times(const V3& a, const V3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline mpq_class inner(const V3& a, const V3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Six times the volume of a tetrahedron, positive where d lies below a, b, c.
inline mpq_class six_volumes(const std::array<plumb::Point3, 4>& t) {
  const V3 a = exact3(t[0]), b = exact3(t[1]), c = exact3(t[2]), d = exact3(t[3]);
  return -inner(minus(d, a), times(minus(b, a), minus(c, a)));
}

/// Enough digits for every sum of products of doubles that is asked for here.
using Digits = mpf_class;
inline constexpr unsigned kBits = 9000;
inline Digits digits(const mpq_class& x) { return Digits(x, kBits); }
inline Digits root(const mpq_class& x) { return Digits(sqrt(digits(x)), kBits); }

/// Machin's formula.
inline Digits machin_pi() {
  const auto arctangent_of_inverse = [](unsigned long n) {
    Digits power(1, kBits), sum(0, kBits);
    power /= n;
    for (unsigned long k = 1; k < 20000; k += 2) {
      const Digits term(power / k, kBits);
      if (k % 4 == 1) {
        sum += term;
      } else {
        sum -= term;
      }
      power /= n * n;
      if (power < Digits("1e-400", kBits)) break;
    }
    return sum;
  };
  return Digits(16 * arctangent_of_inverse(5) - 4 * arctangent_of_inverse(239), kBits);
}

/// How far off x is, in halves of the gap to the double beyond: at most 1 for the nearest.
inline double half_gaps_off(double x, const Digits& exact) {
  const double infinity = std::numeric_limits<double>::infinity();
  if (std::isinf(x)) return exact >= std::numeric_limits<double>::max() ? 0 : infinity;
  const Digits off(exact - x, kBits);
  const double beyond = std::nextafter(x, off > 0 ? infinity : -infinity);
  if (std::isinf(beyond)) return 0;
  return Digits(abs(off) * 2 / Digits(std::fabs(beyond - x), kBits), kBits).get_d();
}

}  // namespace plumb_test
