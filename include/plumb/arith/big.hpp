// What is the exact value, whatever its size?  GMP's integers and rationals as numbers a formula can run over.
//
// Laws: exact; of any double.  Only .cpp files of cold stages and oracles include this header: users of the signs never
// see GMP.  Source: GMP 6.2 manual.  Cost: an allocation for each intermediate value, about a microsecond a predicate.
#pragma once

#include <gmpxx.h>

#include "plumb/arith/lattice.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

template <class Value>
struct Big {
  Value value;

  [[nodiscard]] Sign sign() const { return sign_of_number(sgn(value)); }

  // Evaluated here: an expression template would outlive its operands.
  friend Big operator+(const Big& a, const Big& b) { return {Value(a.value + b.value)}; }
  friend Big operator-(const Big& a, const Big& b) { return {Value(a.value - b.value)}; }
  friend Big operator*(const Big& a, const Big& b) { return {Value(a.value * b.value)}; }
};

using BigInteger = Big<mpz_class>;
using BigRational = Big<mpq_class>;

/// x / 2^exponent for a finite x on that lattice.
inline BigInteger big_integer(double x, int exponent) {
  const OddForm f = odd_form(x);
  BigInteger r{mpz_class(static_cast<long>(f.mantissa))};
  if (f.mantissa != 0) r.value <<= static_cast<unsigned long>(f.exponent - exponent);
  return r;
}

inline BigRational big_rational(double x) { return {mpq_class(x)}; }

}  // namespace plumb
