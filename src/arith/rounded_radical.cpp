#include "arith/rounded_radical.hpp"

#include <cmath>
#include <optional>

namespace plumb {
namespace {

/// m 2^e, for any e.
BigDyadic scaled(const mpz_class& m, long e) {
  BigDyadic r(m);
  for (; e < -900; e += 900) r = r * BigDyadic(0x1p-900);
  for (; e > 900; e -= 900) r = r * BigDyadic(0x1p900);
  return r * BigDyadic(std::ldexp(1.0, static_cast<int>(e)));
}

/// `tell` of a + b sqrt(c): what is told of both ends of an interval around it, where that is the same.
template <class Tell>
double told_of_radical(const BigDyadic& a, const BigDyadic& b, const BigDyadic& c, const Tell& tell) {
  if (b.sign() == Sign::zero || c.sign() == Sign::zero) return *tell(a);
  mpz_class m = c.mantissa();
  long e = c.exponent();
  if ((e & 1) != 0) m <<= 1, --e;
  if (mpz_perfect_square_p(m.get_mpz_t()) != 0) {
    const mpz_class root = sqrt(m);
    return *tell(a + b * scaled(root, e / 2));
  }
  // The root is irrational, and so is the result, which then is neither a double nor half way between two: the ends of
  // its interval, which shrinks to a fraction of its square with each turn, round alike in the end.
  for (unsigned long digits = 128;; digits *= 2) {
    const mpz_class below = sqrt(mpz_class(m << 2 * digits)), above = below + 1;
    const long exponent = e / 2 - static_cast<long>(digits);
    const std::optional<double> one = tell(a + b * scaled(below, exponent));
    const std::optional<double> other = tell(a + b * scaled(above, exponent));
    if (one && one == other) return *one;
  }
}

}  // namespace

double rounded_radical(Rounding rounding, const BigDyadic& a, const BigDyadic& b, const BigDyadic& c,
                       const BigDyadic& d) {
  return told_of_radical(a, b, c,
                         [&](const BigDyadic& x) -> std::optional<double> { return rounded_quotient(rounding, x, d); });
}

double rounded_nested_root(Rounding rounding, const BigDyadic& a, const BigDyadic& b, const BigDyadic& c,
                           const BigDyadic& d) {
  return told_of_radical(a, b, c, [&](const BigDyadic& x) -> std::optional<double> {
    if (x.sign() == Sign::negative) return {};  // an end that is beyond zero, of what is not
    return rounded_root(rounding, x, d);
  });
}

}  // namespace plumb
