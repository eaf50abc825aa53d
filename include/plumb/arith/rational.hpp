// What is the exact number?  A quotient of integers that can be held, computed with and compared.
//
//   Rational(1, 3)                    a fraction; integers of any width, doubles and other rational numbers
//   Rational::from_text("-2.5e-3")    a decimal, an integer, or a fraction of two: "1/3", "0.1/7"
//
// Laws: (1) exact; every finite double and every integer is a rational number, and so is every decimal.  (2) A value:
// copied, moved and compared as one; equal numbers are equal however they were made, and zero has no sign.
// (3) rounded(r) is the double that the rounding names; infinite beyond all doubles where the rounding leads there.
// (4) from_text(r.text()) is r; numerator / denominator is r, both are integers in lowest terms, the denominator above
// 0.
// A double that is NaN or infinite throws NonFinite, a quotient by zero DegeneratePoint; text that is no number throws
// Error, which shows it.  GMP's own types: arith/gmp.hpp, for those who have them.
// Source: GMP 6.2 manual, behind this header.
// Cost: an allocation a number, below a microsecond an operation on numbers of a few hundred bits.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "plumb/arith/rounding.hpp"
#include "plumb/arith/sign.hpp"

namespace plumb {

struct BigRational;  // GMP's, in arith/big.hpp

class Rational {
 public:
  Rational() : Rational(0.0) {}
  Rational(double x);              // NOLINT: a double is a rational number
  Rational(long double) = delete;  // would be rounded
  template <std::integral Integer>
  requires(sizeof(Integer) <= 8) Rational(Integer x)  // NOLINT: and so is an integer
      : Rational(x < 0, x < 0 ? -static_cast<std::uint64_t>(x) : static_cast<std::uint64_t>(x), Magnitude{}) {}
  Rational(const Rational& numerator, const Rational& denominator);
  explicit Rational(BigRational x);
  Rational(const Rational& other);
  Rational(Rational&& other) noexcept;
  Rational& operator=(const Rational& other);
  Rational& operator=(Rational&& other) noexcept;
  ~Rational();

  /// Digits with or without a point and a sign, and a power of ten behind e or E; or two such with / between them.  A
  /// power of ten beyond 10,000, which names a number too long to be meant, throws too.
  static Rational from_text(std::string_view text);

  friend Rational operator+(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a, const Rational& b);
  friend Rational operator*(const Rational& a, const Rational& b);
  friend Rational operator/(const Rational& a, const Rational& b);
  friend Rational operator-(const Rational& a);

  friend bool operator==(const Rational& a, const Rational& b);
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b);

  [[nodiscard]] Sign sign() const;
  [[nodiscard]] double rounded(Rounding rounding = Rounding::nearest) const;

  [[nodiscard]] Rational numerator() const;
  [[nodiscard]] Rational denominator() const;
  [[nodiscard]] bool is_integer() const;
  /// The largest integer that is not above, the least that is not below.
  [[nodiscard]] Rational floor() const;
  [[nodiscard]] Rational ceil() const;
  /// The number itself, where it is an integer of 64 bits.
  [[nodiscard]] std::optional<std::int64_t> to_int64() const;

  /// In lowest terms: "-3/8", "5".
  [[nodiscard]] std::string text() const;
  /// For .cpp files that compute with GMP.
  [[nodiscard]] const BigRational& value() const { return *value_; }

 private:
  struct Magnitude {};
  Rational(bool negative, std::uint64_t magnitude, Magnitude);

  std::unique_ptr<BigRational> value_;  // never null but in what was moved from
};

/// The square root of x, rounded; x must not be negative: ask its sign before.
double rounded_root(Rounding rounding, const Rational& x);

}  // namespace plumb
