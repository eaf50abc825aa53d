// What is the sign of a polynomial here, and what do two polynomials have in common?  Integer polynomials in one
// variable.
//
// A polynomial lists its coefficients in ascending order and ends with one that is not zero; zero has none.
// Laws: everything is exact.  A greatest common divisor, a square-free part and a quotient are primitive (their
// coefficients have no common divisor), so signs are kept up to one sign for the whole polynomial.
// Source: Knuth, TAOCP 4.6.1; Sturm 1829.
// Cost: a few microseconds for the degrees in use, which are below 7.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <vector>

namespace plumb::arith {

using Polynomial = std::vector<mpz_class>;

/// mantissa / 2^places.
struct DyadicPlace {
  mpz_class mantissa;
  unsigned long places = 0;
};

inline std::size_t degree(const Polynomial& p) { return p.empty() ? 0 : p.size() - 1; }

/// Drops leading zeros and the common divisor of the coefficients.
void make_primitive(Polynomial& p);

Polynomial derivative(const Polynomial& p);

/// Of two polynomials that are not both zero.
Polynomial greatest_common_divisor(Polynomial p, Polynomial q);

/// p / q, which must leave no remainder.
Polynomial exact_quotient(Polynomial p, const Polynomial& q);

/// A polynomial with the same roots, each of them once.
Polynomial square_free_part(Polynomial p);

/// How many numbers above zero are roots of p, of which zero is none?  By Sturm's theorem: as many operations whatever the roots are, where
/// isolating them takes a step for each bit by which their sizes differ.
int count_positive_roots(const Polynomial& p);

/// -1, 0 or 1.
int sign_at(const Polynomial& p, const DyadicPlace& x);
int sign_at(const Polynomial& p, const mpq_class& x);

/// p at mantissa / 2^places, times 2^(places * degree).
mpz_class scaled_value(const Polynomial& p, const DyadicPlace& x);

/// How often the sign changes along the Bernstein coefficients of p on [lower, upper] / 2^places: the number of its
/// roots strictly between, counted with multiplicity, or an even number more.  The sign of all coefficients that are
/// not zero is told as well, where they have only one.
struct Variations {
  int count;
  int sign;           // 0 where count is not
  bool zero_at_ends;  // at one of them
};
Variations variations(const Polynomial& p, const mpz_class& lower, const mpz_class& upper, unsigned long places);

}  // namespace plumb::arith
