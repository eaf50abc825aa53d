// Multiple precision: what is the exact value, whatever its size?  GMP's numbers as numbers a formula can run over.
//
// Laws: exact; of any finite double.  A BigDyadic holds no more bits than lie between the ends of its value, so that
// coordinates of very different size cost what their digits cost, not what their exponents span.
// Only .cpp files of cold stages and oracles include this header: users of the signs never see GMP.
// Source: GMP 6.2 manual.
// Cost: 5 to 20 ns an operation on a few limbs; beyond 1,024 bits, and for rationals, an allocation each.
#pragma once

#include <gmpxx.h>

#include <memory>
#include <utility>

#include "plumb/arith/short_dyadic.hpp"
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
  explicit BigDyadic(double x) : short_(x) {}
  explicit BigDyadic(const mpz_class& x);
  BigDyadic(const BigDyadic& x) : short_(x.short_), large_(x.large_ ? std::make_unique<Large>(*x.large_) : nullptr) {}
  BigDyadic(BigDyadic&& x) noexcept = default;
  BigDyadic& operator=(const BigDyadic& x) { return *this = BigDyadic(x); }
  BigDyadic& operator=(BigDyadic&& x) noexcept = default;
  ~BigDyadic() = default;

  [[nodiscard]] Sign sign() const {
    return large_ == nullptr ? short_.sign().value() : sign_of_number(sgn(large_->mantissa));
  }
  [[nodiscard]] mpz_class mantissa() const;
  [[nodiscard]] long exponent() const { return large_ == nullptr ? short_.exponent() : large_->exponent; }

  friend BigDyadic operator+(const BigDyadic& a, const BigDyadic& b) { return sum(a, b, false); }
  friend BigDyadic operator-(const BigDyadic& a, const BigDyadic& b) { return sum(a, b, true); }
  friend BigDyadic operator*(const BigDyadic& a, const BigDyadic& b) { return product(a, b); }

 private:
  struct Large {
    mpz_class mantissa;
    long exponent;
  };
  class View;
  explicit BigDyadic(const ShortDyadic& x) : short_(x) {}
  explicit BigDyadic(Large x);
  static BigDyadic sum(const BigDyadic& a, const BigDyadic& b, bool subtract);
  static BigDyadic product(const BigDyadic& a, const BigDyadic& b);

  ShortDyadic short_;             // what it is
  std::unique_ptr<Large> large_;  // unless it takes more limbs
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
