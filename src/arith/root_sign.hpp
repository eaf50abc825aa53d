// Quadratic radical: which sign has a + b sqrt(c), in rational numbers?
//
// Where the terms disagree, their squares tell.
// Laws: exact, for c >= 0; negating a and b flips the sign.
// Source: RTCD 4.3 (radii); repeated squaring, predicates/radical.hpp.
// Cost: three products where the terms disagree.
#pragma once

#include <gmpxx.h>

#include "plumb/arith/rational.hpp"

namespace plumb {

inline Sign sign_of_rational(const Rational& x) { return x.sign(); }
inline Sign sign_of_rational(const mpq_class& x) { return static_cast<Sign>(sgn(x)); }

template <class Number>
Sign sign_of_root(const Number& a, const Number& b, const Number& c) {
  const Sign s = sign_of_rational(a), t = sign_of_rational(b) * sign_of_rational(c);
  if (s == t || t == Sign::zero) return s;
  if (s == Sign::zero) return t;
  return s * sign_of_rational(Number(a * a - b * b * c));
}

}  // namespace plumb
