// Multiple precision: what is the exact value, whatever its size?  GMP's numbers as numbers a formula can run over.
//
// Laws: exact; of any finite double.  A BigDyadic holds no more bits than lie between the ends of its value, so that
// coordinates of very different size cost what their digits cost, not what their exponents span.
// Only .cpp files of cold stages and oracles include this header: users of the signs never see GMP.
// Source: GMP 6.2 manual.
// Cost: an allocation for each intermediate value, about a microsecond a predicate.
#pragma once

#include <gmpxx.h>

#include <utility>

#include "plumb/arith/lattice.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

/// A rational number: the oracle.
struct BigRational {
  mpq_class value;

  [[nodiscard]] Sign sign() const { return sign_of_number(sgn(value)); }

  // Evaluated here: an expression template would outlive its operands.
  friend BigRational operator+(const BigRational& a, const BigRational& b) { return {mpq_class(a.value + b.value)}; }
  friend BigRational operator-(const BigRational& a, const BigRational& b) { return {mpq_class(a.value - b.value)}; }
  friend BigRational operator*(const BigRational& a, const BigRational& b) { return {mpq_class(a.value * b.value)}; }
};

inline BigRational big_rational(double x) { return {mpq_class(x)}; }

/// An integer times a power of two: the last stage.
class BigDyadic {
 public:
  BigDyadic() = default;
  explicit BigDyadic(double x) {
    const OddForm f = odd_form(x);
    mantissa_ = static_cast<long>(f.mantissa);
    exponent_ = f.exponent;
  }
  explicit BigDyadic(mpz_class x) : mantissa_(std::move(x)) {}

  [[nodiscard]] Sign sign() const { return sign_of_number(sgn(mantissa_)); }
  [[nodiscard]] const mpz_class& mantissa() const { return mantissa_; }
  [[nodiscard]] long exponent() const { return exponent_; }

  friend BigDyadic operator+(const BigDyadic& a, const BigDyadic& b) { return sum(a, b, mpz_add); }
  friend BigDyadic operator-(const BigDyadic& a, const BigDyadic& b) { return sum(a, b, mpz_sub); }
  friend BigDyadic operator*(const BigDyadic& a, const BigDyadic& b) {
    BigDyadic r;
    r.mantissa_ = a.mantissa_ * b.mantissa_;
    r.exponent_ = a.exponent_ + b.exponent_;
    return r;
  }

 private:
  // The term of the larger exponent is shifted to the other's; a zero is not, for its exponent says nothing of its
  // size.
  static BigDyadic sum(const BigDyadic& a, const BigDyadic& b, void (*add)(mpz_ptr, mpz_srcptr, mpz_srcptr)) {
    BigDyadic r;
    mpz_ptr to = r.mantissa_.get_mpz_t();
    mpz_srcptr left = a.mantissa_.get_mpz_t(), right = b.mantissa_.get_mpz_t();
    const bool shift = mpz_sgn(left) != 0 && mpz_sgn(right) != 0;
    r.exponent_ = mpz_sgn(left) == 0 ? b.exponent_ : a.exponent_;
    if (shift && a.exponent_ > b.exponent_) {
      mpz_mul_2exp(to, left, static_cast<mp_bitcnt_t>(a.exponent_ - b.exponent_));
      r.exponent_ = b.exponent_;
      left = to;
    } else if (shift && b.exponent_ > a.exponent_) {
      mpz_mul_2exp(to, right, static_cast<mp_bitcnt_t>(b.exponent_ - a.exponent_));
      right = to;
    }
    add(to, left, right);
    r.drop_trailing_zeros();
    return r;
  }
  // Where they fill limbs: cancellation leaves them, and products would carry them along.
  void drop_trailing_zeros() {
    if (sgn(mantissa_) == 0) return;
    const unsigned long zeros = mpz_scan1(mantissa_.get_mpz_t(), 0);
    if (zeros < GMP_NUMB_BITS) return;
    mantissa_ >>= zeros;
    exponent_ += static_cast<long>(zeros);
  }

  mpz_class mantissa_;
  long exponent_ = 0;
};

inline BigDyadic magnitude(const BigDyadic& x) { return x.sign() == Sign::negative ? BigDyadic() - x : x; }

/// The same number.
inline BigRational big_rational(const BigDyadic& x) {
  mpq_class r(x.mantissa());
  if (x.exponent() >= 0) {
    mpq_mul_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(x.exponent()));
  } else {
    mpq_div_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(-x.exponent()));
  }
  return {std::move(r)};
}

}  // namespace plumb
