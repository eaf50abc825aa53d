// Radicals by as many digits as their separation from zero asks for.
#include <algorithm>

#include "oracle/radicals.hpp"

namespace plumb::oracle {
namespace {

// The floor of sqrt(x) 2^digits.
mpz_class root(const mpz_class& x, mp_bitcnt_t digits) {
  mpz_class scaled = x << (2 * digits), r;
  mpz_sqrt(r.get_mpz_t(), scaled.get_mpz_t());
  return r;
}

std::size_t bits(const mpz_class& x) { return mpz_sizeinbase(x.get_mpz_t(), 2); }

}  // namespace

Sign digits_sign(const Radicals& r) {
  // b sqrt(c) = (b / q) sqrt(c q^2) for the denominator q of c; then a, b and d take one denominator.
  mpq_class a = r[0], b = r[1] / r[2].get_den(), d = r[3] / r[4].get_den();
  const mpz_class c = r[2].get_num() * r[2].get_den(), e = r[4].get_num() * r[4].get_den();
  mpz_class denominator;
  mpz_lcm(denominator.get_mpz_t(), a.get_den_mpz_t(), b.get_den_mpz_t());
  mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), d.get_den_mpz_t());
  for (mpq_class* x : {&a, &b, &d}) *x *= denominator;
  const mpz_class ia = a.get_num(), ib = b.get_num(), id = d.get_num();
  // M < 2^size, so a nonzero sum is beyond 2^(-3 size); each root is off by less than 2^-digits.
  const std::size_t size = std::max({bits(ia), bits(ib) + bits(c) / 2 + 1, bits(id) + bits(e) / 2 + 1}) + 2;
  const mp_bitcnt_t digits = 3 * size + std::max(bits(ib), bits(id)) + 4;
  const mpz_class sum = (ia << digits) + ib * root(c, digits) + id * root(e, digits);
  const mpz_class error = abs(ib) + abs(id);
  if (sum > error) return Sign::positive;
  if (sum < -error) return Sign::negative;
  return Sign::zero;
}

}  // namespace plumb::oracle
