// Signs of sqrt(s) - r - sqrt(t) + u in rationals: moved to one side, squared, and squared again.
#include "plumb/arith/exact_distance.hpp"

#include "arith/root_sign.hpp"

namespace plumb {
namespace {

/// The sign of a + sqrt(b) - sqrt(c).
Sign sign_of_roots(const Rational& a, const Rational& b, const Rational& c) {
  const Sign rest = (b - c).sign(), s = a.sign();
  if (s == rest || rest == Sign::zero) return s;
  if (s == Sign::zero) return rest;
  // a and the rest disagree: a^2 against b + c - 2 sqrt(b c).
  return s * sign_of_root(a * a - b - c, Rational(2.0), b * c);
}

bool is_zero(const ExactDistance& d) { return sign_of_root(-d.inset, Rational(1.0), d.square) != Sign::positive; }

}  // namespace

Sign compare(const ExactDistance& a, const ExactDistance& b) {
  const bool a_is_zero = is_zero(a), b_is_zero = is_zero(b);
  if (a_is_zero) return b_is_zero ? Sign::zero : Sign::negative;
  if (b_is_zero) return Sign::positive;
  return sign_of_roots(b.inset - a.inset, a.square, b.square);
}

Sign compare(const ExactDistance& a, double b) {
  if (b < 0) return Sign::positive;
  const bool a_is_zero = is_zero(a);
  if (b == 0) return a_is_zero ? Sign::zero : Sign::positive;
  if (a_is_zero) return Sign::negative;
  return sign_of_root(-a.inset - Rational(b), Rational(1.0), a.square);
}

}  // namespace plumb
