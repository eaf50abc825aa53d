// GMP's classes of integers and fractions, over Boost.Multiprecision's cpp_int: see gmp.h beside this.
//
// Laws: as in GMP's manual.  Fractions that arithmetic makes of such in lowest terms are in lowest terms; an operation's
// result is a number, not an expression, so that `auto` holds it as well.
// Source: GMP 6.2 manual, C++ interface; Knuth, TAOCP 4.5.1.
// Cost: a greatest common divisor for each operation on fractions.
#pragma once

#include <gmp.h>

#include <compare>
#include <concepts>
#include <stdexcept>
#include <string>
#include <utility>

class mpz_class {
 public:
  mpz_class() = default;
  template <std::integral Number>
  mpz_class(Number x) : z_{boost_number::Integer(x)} {}  // NOLINT: converts, as GMP's does
  template <std::floating_point Number>
  mpz_class(Number x) : z_{boost_number::Integer(x)} {}  // NOLINT: rounds toward zero, as GMP's does
  explicit mpz_class(boost_number::Integer x) : z_{std::move(x)} {}
  explicit mpz_class(mpz_srcptr x) : z_(*x) {}
  /// Decimal digits, with a minus before them or not.
  explicit mpz_class(const std::string& digits, int base = 10) {
    if (base != 10) throw std::invalid_argument("mpz_class: decimal digits alone");
    const bool negative = digits.starts_with('-');
    const std::size_t first = digits.find_first_not_of('0', negative ? 1 : 0);  // a zero would say that it is octal
    if (digits.find_first_not_of("0123456789", negative ? 1 : 0) != std::string::npos || digits.size() == negative)
      throw std::invalid_argument("mpz_class: no number");
    if (first != std::string::npos) z_.value.assign(digits.substr(first));
    if (negative) z_.value = -z_.value;
  }

  [[nodiscard]] mpz_ptr get_mpz_t() { return &z_; }
  [[nodiscard]] mpz_srcptr get_mpz_t() const { return &z_; }
  [[nodiscard]] const boost_number::Integer& number() const { return z_.value; }
  /// The lowest 64 bits of the magnitude.
  [[nodiscard]] std::uint64_t get_ui() const { return mpz_size(&z_) == 0 ? 0 : *mpz_limbs_read(&z_); }
  [[nodiscard]] std::int64_t get_si() const { return static_cast<std::int64_t>(z_.value); }
  [[nodiscard]] bool fits_slong_p() const {
    return z_.value >= std::numeric_limits<std::int64_t>::min() && z_.value <= std::numeric_limits<std::int64_t>::max();
  }
  [[nodiscard]] double get_d() const { return boost_toward_zero(z_.value, 0); }
  [[nodiscard]] std::string get_str() const { return z_.value.str(); }
  void swap(mpz_class& x) noexcept { z_.value.swap(x.z_.value); }

  mpz_class& operator+=(const mpz_class& x) { return z_.value += x.z_.value, *this; }
  mpz_class& operator-=(const mpz_class& x) { return z_.value -= x.z_.value, *this; }
  mpz_class& operator*=(const mpz_class& x) { return z_.value *= x.z_.value, *this; }
  mpz_class& operator/=(const mpz_class& x) { return z_.value /= x.z_.value, *this; }
  mpz_class& operator%=(const mpz_class& x) { return z_.value %= x.z_.value, *this; }
  mpz_class& operator<<=(mp_bitcnt_t bits) { return z_.value <<= bits, *this; }
  mpz_class& operator>>=(mp_bitcnt_t bits) { return mpz_fdiv_q_2exp(&z_, &z_, bits), *this; }
  mpz_class& operator++() { return ++z_.value, *this; }
  mpz_class& operator--() { return --z_.value, *this; }

  friend mpz_class operator+(mpz_class a, const mpz_class& b) { return a += b; }
  friend mpz_class operator-(mpz_class a, const mpz_class& b) { return a -= b; }
  friend mpz_class operator*(mpz_class a, const mpz_class& b) { return a *= b; }
  friend mpz_class operator/(mpz_class a, const mpz_class& b) { return a /= b; }
  friend mpz_class operator%(mpz_class a, const mpz_class& b) { return a %= b; }
  friend mpz_class operator<<(mpz_class a, mp_bitcnt_t bits) { return a <<= bits; }
  friend mpz_class operator>>(mpz_class a, mp_bitcnt_t bits) { return a >>= bits; }
  friend mpz_class operator-(const mpz_class& a) { return mpz_class(boost_number::Integer(-a.z_.value)); }
  friend bool operator==(const mpz_class& a, const mpz_class& b) { return a.z_.value == b.z_.value; }
  friend std::strong_ordering operator<=>(const mpz_class& a, const mpz_class& b) {
    return a.z_.value.compare(b.z_.value) <=> 0;
  }

  friend int sgn(const mpz_class& x) { return x.z_.value.sign(); }
  friend int cmp(const mpz_class& a, const mpz_class& b) { return a.z_.value.compare(b.z_.value); }
  friend mpz_class abs(const mpz_class& x) { return sgn(x) < 0 ? -x : x; }
  friend mpz_class gcd(const mpz_class& a, const mpz_class& b) { return mpz_class(gcd(a.z_.value, b.z_.value)); }
  friend mpz_class lcm(const mpz_class& a, const mpz_class& b) { return mpz_class(lcm(a.z_.value, b.z_.value)); }
  friend mpz_class sqrt(const mpz_class& x) { return mpz_class(sqrt(x.z_.value)); }
  friend void swap(mpz_class& a, mpz_class& b) noexcept { a.swap(b); }

 private:
  BoostMpz z_;
};

class mpq_class;
struct BoostMpq {
  mpz_class numerator, denominator = 1;
};
using mpq_ptr = BoostMpq*;
using mpq_srcptr = const BoostMpq*;

inline void mpq_canonicalize(mpq_ptr q) {
  const mpz_class divisor =
      sgn(q->denominator) < 0 ? -gcd(q->numerator, q->denominator) : gcd(q->numerator, q->denominator);
  if (divisor == 1) return;
  q->numerator /= divisor;
  q->denominator /= divisor;
}
inline void mpq_neg(mpq_ptr r, mpq_srcptr q) {
  r->numerator = -q->numerator;
  r->denominator = q->denominator;
}
inline void mpq_mul_2exp(mpq_ptr r, mpq_srcptr q, mp_bitcnt_t bits) {
  BoostMpq product = *q;
  product.numerator <<= bits;
  mpq_canonicalize(&product);
  *r = std::move(product);
}
inline void mpq_div_2exp(mpq_ptr r, mpq_srcptr q, mp_bitcnt_t bits) {
  BoostMpq quotient = *q;
  quotient.denominator <<= bits;
  mpq_canonicalize(&quotient);
  *r = std::move(quotient);
}

class mpq_class {
 public:
  mpq_class() = default;
  mpq_class(mpz_class x) : q_{std::move(x)} {}  // NOLINT: converts, as GMP's does in expressions
  template <std::integral Number>
  mpq_class(Number x) : q_{mpz_class(x)} {}  // NOLINT
  /// Exactly; of what is finite.
  mpq_class(double x) {  // NOLINT
    int exponent = 0;
    const double digits = std::ldexp(std::frexp(x, &exponent), 53);
    exponent -= 53;
    q_.numerator = static_cast<std::int64_t>(digits);
    if (exponent >= 0) {
      q_.numerator <<= static_cast<mp_bitcnt_t>(exponent);
    } else {
      mpq_div_2exp(&q_, &q_, static_cast<mp_bitcnt_t>(-exponent));
    }
  }
  /// As they are: canonicalize() makes lowest terms of them.
  mpq_class(mpz_class numerator, mpz_class denominator) : q_{std::move(numerator), std::move(denominator)} {}

  void canonicalize() { mpq_canonicalize(&q_); }
  [[nodiscard]] mpq_ptr get_mpq_t() { return &q_; }
  [[nodiscard]] mpq_srcptr get_mpq_t() const { return &q_; }
  [[nodiscard]] mpz_class& get_num() { return q_.numerator; }
  [[nodiscard]] mpz_class& get_den() { return q_.denominator; }
  [[nodiscard]] const mpz_class& get_num() const { return q_.numerator; }
  [[nodiscard]] const mpz_class& get_den() const { return q_.denominator; }
  [[nodiscard]] mpz_ptr get_num_mpz_t() { return q_.numerator.get_mpz_t(); }
  [[nodiscard]] mpz_ptr get_den_mpz_t() { return q_.denominator.get_mpz_t(); }
  [[nodiscard]] mpz_srcptr get_num_mpz_t() const { return q_.numerator.get_mpz_t(); }
  [[nodiscard]] mpz_srcptr get_den_mpz_t() const { return q_.denominator.get_mpz_t(); }
  [[nodiscard]] std::string get_str() const {
    return q_.denominator == 1 ? q_.numerator.get_str() : q_.numerator.get_str() + "/" + q_.denominator.get_str();
  }
  /// Toward zero.
  [[nodiscard]] double get_d() const {
    if (sgn(q_.numerator) == 0) return 0;
    // The quotient has 64 bits or 65: what it leaves out is below what a double holds.
    const long shift = 65 + static_cast<long>(mpz_sizeinbase(get_den_mpz_t(), 2)) -
                       static_cast<long>(mpz_sizeinbase(get_num_mpz_t(), 2));
    const mpz_class &n = q_.numerator, &d = q_.denominator;
    const mpz_class quotient =
        shift >= 0 ? (n << static_cast<mp_bitcnt_t>(shift)) / d : n / (d << static_cast<mp_bitcnt_t>(-shift));
    return boost_toward_zero(quotient.number(), -shift);
  }
  void swap(mpq_class& x) noexcept { std::swap(q_, x.q_); }

  mpq_class& operator+=(const mpq_class& x) { return *this = *this + x; }
  mpq_class& operator-=(const mpq_class& x) { return *this = *this - x; }
  mpq_class& operator*=(const mpq_class& x) { return *this = *this * x; }
  mpq_class& operator/=(const mpq_class& x) { return *this = *this / x; }

  friend mpq_class operator+(const mpq_class& a, const mpq_class& b) {
    return lowest(a.get_num() * b.get_den() + b.get_num() * a.get_den(), a.get_den() * b.get_den());
  }
  friend mpq_class operator-(const mpq_class& a, const mpq_class& b) {
    return lowest(a.get_num() * b.get_den() - b.get_num() * a.get_den(), a.get_den() * b.get_den());
  }
  friend mpq_class operator*(const mpq_class& a, const mpq_class& b) {
    return lowest(a.get_num() * b.get_num(), a.get_den() * b.get_den());
  }
  friend mpq_class operator/(const mpq_class& a, const mpq_class& b) {
    return lowest(a.get_num() * b.get_den(), a.get_den() * b.get_num());
  }
  friend mpq_class operator<<(mpq_class a, mp_bitcnt_t bits) { return mpq_mul_2exp(&a.q_, &a.q_, bits), a; }
  friend mpq_class operator>>(mpq_class a, mp_bitcnt_t bits) { return mpq_div_2exp(&a.q_, &a.q_, bits), a; }
  friend mpq_class operator-(const mpq_class& a) { return {-a.get_num(), a.get_den()}; }
  friend bool operator==(const mpq_class& a, const mpq_class& b) {
    return a.get_num() == b.get_num() && a.get_den() == b.get_den();
  }
  friend std::strong_ordering operator<=>(const mpq_class& a, const mpq_class& b) { return cmp(a, b) <=> 0; }

  friend int sgn(const mpq_class& x) { return sgn(x.get_num()); }
  friend int cmp(const mpq_class& a, const mpq_class& b) {
    return cmp(a.get_num() * b.get_den(), b.get_num() * a.get_den());
  }
  friend mpq_class abs(const mpq_class& x) { return {abs(x.get_num()), x.get_den()}; }
  friend void swap(mpq_class& a, mpq_class& b) noexcept { a.swap(b); }

 private:
  static mpq_class lowest(mpz_class numerator, mpz_class denominator) {
    mpq_class r(std::move(numerator), std::move(denominator));
    r.canonicalize();
    return r;
  }

  BoostMpq q_;
};
