// GMP's functions that this library calls, over Boost.Multiprecision's cpp_int: what stands behind the last stages where
// there is no GMP, as in a browser.  CMake's PLUMB_EXACT_NUMBER=boost puts this folder where GMP's headers would be.
//
// Laws: names, arguments and results are those of GMP's manual; whatever is missing does not compile.  A limb has 64 bits
// also where `long` has 32.
// Source: GMP 6.2 manual; Knuth, TAOCP 4.3.1, for what is done limb by limb.
// Cost: an allocation beyond two limbs; products by the school's rule, which suffices for the lengths that occur.
#pragma once

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#define GMP_NUMB_BITS 64
using mp_limb_t = boost::multiprecision::limb_type;
using mp_size_t = long;
using mp_bitcnt_t = unsigned long;

namespace plumb::arith::boost_number {

__extension__ using TwoLimbs = unsigned __int128;
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>, boost::multiprecision::et_off>;
static_assert(sizeof(mp_limb_t) == 8, "cpp_int has limbs of 64 bits where the compiler has integers of 128");
static_assert(sizeof(double) == 8 && std::numeric_limits<double>::is_iec559);

inline mp_limb_t add_limb(mp_limb_t a, mp_limb_t b, mp_limb_t& carry) {
  const TwoLimbs s = TwoLimbs{a} + b + carry;
  carry = static_cast<mp_limb_t>(s >> GMP_NUMB_BITS);
  return static_cast<mp_limb_t>(s);
}
inline mp_limb_t subtract_limb(mp_limb_t a, mp_limb_t b, mp_limb_t& borrow) {
  const TwoLimbs d = TwoLimbs{a} - b - borrow;
  borrow = static_cast<mp_limb_t>(d >> GMP_NUMB_BITS) & 1;
  return static_cast<mp_limb_t>(d);
}

}  // namespace plumb::arith::boost_number

namespace boost_number = plumb::arith::boost_number;

// Limbs, least significant first.  A result may stand where a term stood; that of a product or a shift may not, but for
// a shift in place.

inline mp_limb_t mpn_add(mp_limb_t* r, const mp_limb_t* a, mp_size_t n, const mp_limb_t* b, mp_size_t m) {
  mp_limb_t carry = 0;
  for (mp_size_t i = 0; i < n; ++i) r[i] = boost_number::add_limb(a[i], i < m ? b[i] : 0, carry);
  return carry;
}
inline mp_limb_t mpn_sub(mp_limb_t* r, const mp_limb_t* a, mp_size_t n, const mp_limb_t* b, mp_size_t m) {
  mp_limb_t borrow = 0;
  for (mp_size_t i = 0; i < n; ++i) r[i] = boost_number::subtract_limb(a[i], i < m ? b[i] : 0, borrow);
  return borrow;
}
inline mp_limb_t mpn_neg(mp_limb_t* r, const mp_limb_t* a, mp_size_t n) {
  mp_limb_t borrow = 0;
  for (mp_size_t i = 0; i < n; ++i) r[i] = boost_number::subtract_limb(0, a[i], borrow);
  return borrow;
}
inline int mpn_cmp(const mp_limb_t* a, const mp_limb_t* b, mp_size_t n) {
  while (n-- > 0) {
    if (a[n] != b[n]) return a[n] < b[n] ? -1 : 1;
  }
  return 0;
}
inline mp_limb_t mpn_mul_1(mp_limb_t* r, const mp_limb_t* a, mp_size_t n, mp_limb_t b) {
  mp_limb_t carry = 0;
  for (mp_size_t i = 0; i < n; ++i) {
    const boost_number::TwoLimbs p = boost_number::TwoLimbs{a[i]} * b + carry;
    r[i] = static_cast<mp_limb_t>(p);
    carry = static_cast<mp_limb_t>(p >> GMP_NUMB_BITS);
  }
  return carry;
}
inline mp_limb_t mpn_mul(mp_limb_t* r, const mp_limb_t* a, mp_size_t n, const mp_limb_t* b, mp_size_t m) {
  r[n] = mpn_mul_1(r, a, n, b[0]);
  for (mp_size_t j = 1; j < m; ++j) {
    mp_limb_t carry = 0;
    for (mp_size_t i = 0; i < n; ++i) {
      const boost_number::TwoLimbs p = boost_number::TwoLimbs{a[i]} * b[j] + r[i + j] + carry;
      r[i + j] = static_cast<mp_limb_t>(p);
      carry = static_cast<mp_limb_t>(p >> GMP_NUMB_BITS);
    }
    r[n + j] = carry;
  }
  return r[n + m - 1];
}
inline void mpn_sqr(mp_limb_t* r, const mp_limb_t* a, mp_size_t n) { mpn_mul(r, a, n, a, n); }
/// `bits` is from 1 to 63.
inline mp_limb_t mpn_lshift(mp_limb_t* r, const mp_limb_t* a, mp_size_t n, unsigned bits) {
  const mp_limb_t over = a[n - 1] >> (GMP_NUMB_BITS - bits);
  for (mp_size_t i = n - 1; i > 0; --i) r[i] = a[i] << bits | a[i - 1] >> (GMP_NUMB_BITS - bits);
  r[0] = a[0] << bits;
  return over;
}

// Integers.

struct BoostMpz {
  boost_number::Integer value;
};
using mpz_t = BoostMpz[1];  // NOLINT: what GMP's is
using mpz_ptr = BoostMpz*;
using mpz_srcptr = const BoostMpz*;

inline int mpz_sgn(mpz_srcptr x) { return x->value.sign(); }
inline std::size_t mpz_size(mpz_srcptr x) { return x->value.is_zero() ? 0 : x->value.backend().size(); }
inline const mp_limb_t* mpz_limbs_read(mpz_srcptr x) { return x->value.backend().limbs(); }
inline mp_limb_t* mpz_limbs_write(mpz_ptr x, mp_size_t n) {
  const auto size = static_cast<unsigned>(n);
  x->value = 0;
  x->value.backend().resize(size, size);
  return x->value.backend().limbs();
}
/// The sign of `size` is the number's.
inline void mpz_limbs_finish(mpz_ptr x, mp_size_t size) {
  const auto limbs = static_cast<unsigned>(std::abs(size));
  if (limbs == 0) {
    x->value = 0;
    return;
  }
  x->value.backend().resize(limbs, limbs);
  x->value.backend().normalize();
  x->value.backend().sign(size < 0 && !x->value.is_zero());
}
inline mpz_srcptr mpz_roinit_n(mpz_ptr x, const mp_limb_t* limbs, mp_size_t size) {
  if (size != 0) std::copy_n(limbs, std::abs(size), mpz_limbs_write(x, std::abs(size)));
  mpz_limbs_finish(x, size);
  return x;
}

inline std::size_t mpz_sizeinbase(mpz_srcptr x, int base) {
  if (base != 2) throw std::logic_error("mpz_sizeinbase: of base 2 alone");
  return mpz_sgn(x) == 0 ? 1 : boost::multiprecision::msb(abs(x->value)) + 1;
}
/// Where the first bit at or after `from` stands that is set; of `from` = 0 and what is not zero.
inline mp_bitcnt_t mpz_scan1(mpz_srcptr x, mp_bitcnt_t from) {
  if (from != 0) throw std::logic_error("mpz_scan1: from the first bit alone");
  return boost::multiprecision::lsb(abs(x->value));
}

inline void mpz_set_si(mpz_ptr r, long x) { r->value = x; }
inline void mpz_add(mpz_ptr r, mpz_srcptr a, mpz_srcptr b) { r->value = a->value + b->value; }
inline void mpz_sub(mpz_ptr r, mpz_srcptr a, mpz_srcptr b) { r->value = a->value - b->value; }
inline void mpz_mul(mpz_ptr r, mpz_srcptr a, mpz_srcptr b) { r->value = a->value * b->value; }
inline void mpz_addmul(mpz_ptr r, mpz_srcptr a, mpz_srcptr b) { r->value += a->value * b->value; }
inline void mpz_submul(mpz_ptr r, mpz_srcptr a, mpz_srcptr b) { r->value -= a->value * b->value; }
inline void mpz_mul_2exp(mpz_ptr r, mpz_srcptr a, mp_bitcnt_t bits) { r->value = a->value << bits; }
inline void mpz_ui_pow_ui(mpz_ptr r, unsigned long base, unsigned long power) {
  r->value = boost::multiprecision::pow(boost_number::Integer(base), static_cast<unsigned>(power));
}

// Quotients: fdiv rounds down, cdiv up, divexact leaves no rest.
inline void mpz_fdiv_qr(mpz_ptr q, mpz_ptr rest, mpz_srcptr a, mpz_srcptr b) {
  const boost_number::Integer divisor = b->value;
  boost_number::Integer quotient, remainder;
  divide_qr(a->value, divisor, quotient, remainder);
  if (remainder.sign() * divisor.sign() < 0) {
    quotient -= 1;
    remainder += divisor;
  }
  q->value = std::move(quotient);
  rest->value = std::move(remainder);
}
inline void mpz_fdiv_q(mpz_ptr q, mpz_srcptr a, mpz_srcptr b) {
  mpz_t rest;
  mpz_fdiv_qr(q, rest, a, b);
}
inline void mpz_cdiv_q(mpz_ptr q, mpz_srcptr a, mpz_srcptr b) {
  mpz_t rest;
  mpz_fdiv_qr(q, rest, a, b);
  if (mpz_sgn(rest) != 0) q->value += 1;
}
inline void mpz_divexact(mpz_ptr q, mpz_srcptr a, mpz_srcptr b) { q->value = a->value / b->value; }
inline int mpz_divisible_p(mpz_srcptr a, mpz_srcptr b) { return a->value % b->value == 0 ? 1 : 0; }
inline void mpz_fdiv_q_2exp(mpz_ptr q, mpz_srcptr a, mp_bitcnt_t bits) {
  const BoostMpz power{boost_number::Integer(1) << bits};
  mpz_fdiv_q(q, a, &power);
}
inline void mpz_cdiv_q_2exp(mpz_ptr q, mpz_srcptr a, mp_bitcnt_t bits) {
  const BoostMpz power{boost_number::Integer(1) << bits};
  mpz_cdiv_q(q, a, &power);
}
inline int mpz_divisible_2exp_p(mpz_srcptr a, mp_bitcnt_t bits) {
  return mpz_sgn(a) == 0 || mpz_scan1(a, 0) >= bits ? 1 : 0;
}
inline unsigned long mpz_fdiv_q_ui(mpz_ptr q, mpz_srcptr a, unsigned long b) {
  const BoostMpz divisor{boost_number::Integer(b)};
  mpz_t rest;
  mpz_fdiv_qr(q, rest, a, &divisor);
  return static_cast<unsigned long>(rest->value);
}
inline unsigned long mpz_cdiv_q_ui(mpz_ptr q, mpz_srcptr a, unsigned long b) {
  const unsigned long rest = mpz_fdiv_q_ui(q, a, b);
  if (rest != 0) q->value += 1;
  return rest == 0 ? 0 : b - rest;
}
inline void mpz_lcm(mpz_ptr r, mpz_srcptr a, mpz_srcptr b) { r->value = lcm(a->value, b->value); }

// Roots of what is not negative.
inline void mpz_sqrtrem(mpz_ptr root, mpz_ptr rest, mpz_srcptr a) {
  boost_number::Integer left;
  root->value = sqrt(a->value, left);
  rest->value = std::move(left);
}
inline void mpz_sqrt(mpz_ptr root, mpz_srcptr a) { root->value = sqrt(a->value); }
inline int mpz_perfect_square_p(mpz_srcptr a) {
  if (mpz_sgn(a) <= 0) return mpz_sgn(a) == 0 ? 1 : 0;
  boost_number::Integer rest;
  sqrt(a->value, rest);
  return rest == 0 ? 1 : 0;
}

/// What x * 2^exponent is toward zero, as GMP rounds.
inline double boost_toward_zero(const boost_number::Integer& x, long exponent) {
  if (x == 0) return 0;
  const boost_number::Integer size = abs(x);
  const long end = static_cast<long>(boost::multiprecision::msb(size)) + 1 + exponent;  // |x| * 2^exponent < 2^end
  const long kept = std::min(53L, end + 1074);                                          // bits that a double has there
  if (kept <= 0) return 0;
  const long dropped = end - exponent - kept;
  const auto digits = static_cast<std::uint64_t>(dropped >= 0 ? size >> dropped : size << -dropped);
  const double r = std::ldexp(static_cast<double>(digits), static_cast<int>(std::min(end - kept, 4096L)));
  return x < 0 ? -r : r;
}
inline double mpz_get_d_2exp(long* exponent, mpz_srcptr x) {
  *exponent = mpz_sgn(x) == 0 ? 0 : static_cast<long>(mpz_sizeinbase(x, 2));
  return boost_toward_zero(x->value, -*exponent);
}
