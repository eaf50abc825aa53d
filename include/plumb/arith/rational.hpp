// What is the exact number?  A quotient of integers that can be held, computed with and compared.
//
// Laws: (1) exact; every finite double is a rational number.  (2) A value: copied, moved and compared as one; equal
// numbers are equal however they were made, and zero has no sign.  (3) rounded(r) is the double that the rounding
// names; infinite beyond all doubles where the rounding leads there. A double that is NaN or infinite throws NonFinite,
// a quotient by zero DegeneratePoint. Source: GMP 6.2 manual, behind this header.  Cost: an allocation a number, below
// a microsecond an operation on numbers of a few hundred bits.
#pragma once

#include <compare>
#include <memory>
#include <string>

#include "plumb/arith/rounding.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

struct BigRational;  // GMP's, in arith/big.hpp

class Rational {
 public:
  Rational() : Rational(0.0) {}
  Rational(double x);  // NOLINT: a double is a rational number
  explicit Rational(BigRational x);
  Rational(const Rational& other);
  Rational(Rational&& other) noexcept;
  Rational& operator=(const Rational& other);
  Rational& operator=(Rational&& other) noexcept;
  ~Rational();

  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  friend Rational operator/(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a);

  friend bool operator==(const Rational& a, const Rational& b);
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);

  [[nodiscard]] Sign sign() const;
  [[nodiscard]] double rounded(Rounding rounding = Rounding::nearest) const;
  /// In lowest terms: "-3/8", "5".
  [[nodiscard]] std::string text() const;
  /// For .cpp files that compute with GMP.
  [[nodiscard]] const BigRational& value() const { return *value_; }

 private:
  std::unique_ptr<BigRational> value_;  // never null but in what was moved from
};

/// The square root of x, rounded; x must not be negative: ask its sign before.
double rounded_root(Rounding rounding, const Rational& x);

}  // namespace plumb
