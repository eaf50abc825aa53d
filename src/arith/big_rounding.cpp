#include "arith/big_rounding.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace plumb {
namespace {

/// q * 2^exponent rounded; `more`: the exact value is a little above q.  2^54 <= q < 2^58.
double rounded_magnitude(Rounding rounding, std::uint64_t q, bool more, long exponent) {
  const std::uint64_t all = q << 1 | static_cast<std::uint64_t>(more);
  const long last = exponent - 1;  // of the last bit of `all`
  const long top = last + static_cast<long>(std::bit_width(all));
  const long drop = std::max(top - 53, -1074L) - last;  // doubles have no finer bits
  if (drop > 62) return rounding == Rounding::up ? std::numeric_limits<double>::denorm_min() : 0;
  const std::uint64_t kept = all >> drop, rest = all & ((1ull << drop) - 1), half = 1ull << (drop - 1);
  bool up = rest > half || (rest == half && (kept & 1) != 0);
  if (rounding != Rounding::nearest) up = rounding == Rounding::up && rest != 0;
  const long place = std::min(last + drop, 2000L);  // beyond every double; fits an int
  const double size = std::ldexp(static_cast<double>(kept + static_cast<std::uint64_t>(up)), static_cast<int>(place));
  return rounding == Rounding::down ? std::min(size, std::numeric_limits<double>::max()) : size;
}

double with_sign(int sign, Rounding rounding, std::uint64_t q, bool more, long exponent) {
  if (sign >= 0) return rounded_magnitude(rounding, q, more, exponent);
  return 0.0 - rounded_magnitude(-rounding, q, more, exponent);
}

long bits_of(const mpz_class& x) { return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)); }

/// left / right in about `bits` bits, times 2^shift; says whether a rest was dropped.
struct Quotient {
  mpz_class value;
  bool more;
  long shift;
};
Quotient divide(const BigDyadic& n, const BigDyadic& d, long bits, bool even) {
  mpz_class left = abs(n.mantissa()), right = abs(d.mantissa()), rest;
  long shift = bits - (bits_of(left) - bits_of(right));
  // The exponent of the result is to be even.
  if (even && ((n.exponent() - d.exponent() - shift) & 1) != 0) ++shift;
  Quotient q;
  if (shift >= 0) {
    left <<= static_cast<mp_bitcnt_t>(shift);
  } else {
    right <<= static_cast<mp_bitcnt_t>(-shift);
  }
  mpz_fdiv_qr(q.value.get_mpz_t(), rest.get_mpz_t(), left.get_mpz_t(), right.get_mpz_t());
  q.more = sgn(rest) != 0;
  q.shift = shift;
  return q;
}

}  // namespace

double rounded(Rounding rounding, const BigDyadic& x) { return rounded_quotient(rounding, x, BigDyadic(1)); }

double rounded(Rounding rounding, const mpq_class& x) {
  return rounded_quotient(rounding, BigDyadic(x.get_num()), BigDyadic(x.get_den()));
}

double rounded_quotient(Rounding rounding, const BigDyadic& n, const BigDyadic& d) {
  const int sign = sgn(n.mantissa()) * sgn(d.mantissa());
  if (sign == 0) return 0;
  const Quotient q = divide(n, d, 56, false);  // of 56 or 57 bits
  return with_sign(sign, rounding, q.value.get_ui(), q.more, n.exponent() - d.exponent() - q.shift);
}

double rounded_root(Rounding rounding, const BigDyadic& n, const BigDyadic& d) {
  if (sgn(n.mantissa()) == 0) return 0;
  const Quotient q = divide(n, d, 111, true);  // of 111 to 113 bits: a root of 56 or 57
  mpz_class root, rest;
  mpz_sqrtrem(root.get_mpz_t(), rest.get_mpz_t(), q.value.get_mpz_t());
  return rounded_magnitude(rounding, root.get_ui(), q.more || sgn(rest) != 0,
                           (n.exponent() - d.exponent() - q.shift) / 2);
}

}  // namespace plumb
