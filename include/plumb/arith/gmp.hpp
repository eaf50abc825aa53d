// How do GMP's numbers and ours become one another?  An optional header, which no other one includes.
//
//   plumb::Rational x = plumb::rational(mpq_class(1, 3));
//   mpq_class q = plumb::mpq(x);          mpz_class n = plumb::mpz(x.floor());
//
// Laws: exact, there and back; fractions come out in lowest terms, and may come in in any.
// A denominator of zero throws DegeneratePoint; mpz of a number that is no integer throws Error, which shows it.
// Who includes it has GMP's C++ interface (Debian: libgmp-dev) and links gmp.
// Source: GMP 6.2 manual.
// Cost: a copy, of fractions a greatest common divisor.
#pragma once

#include <gmpxx.h>

#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/arith/rational.hpp"

namespace plumb {

inline Rational rational(const mpz_class& x) { return Rational(BigRational{mpq_class(x)}); }
inline Rational rational(const mpq_class& x) {
  if (x.get_den() == 0) throw DegeneratePoint("rational: the denominator is zero");
  return Rational(BigRational{x});
}

inline mpq_class mpq(const Rational& x) { return x.value().value; }
inline mpz_class mpz(const Rational& x) {
  if (!x.is_integer()) throw Error("mpz: " + x.text() + " is no integer; take its floor or ceil");
  return x.value().value.get_num();
}

}  // namespace plumb
