// Root isolation: which number makes this polynomial zero?  Real roots that compare exactly: contact times before they
// are rounded.
//
//   real_roots(std::array<Rational, 3>{-2, 0, 1}, 0, 2)   // the square root of 2, alone
//
// A root is a polynomial with rational coefficients and an interval in which it has no other root.
// Laws: (1) <=> and == are those of real numbers: also between roots of different polynomials, of which one number may
// be a root, and between roots and rational numbers.  (2) rounded(r) is the double that the rounding names; infinite
// beyond all doubles where the rounding leads there; never -0.  (3) real_roots gives every real root once, whatever
// its multiplicity, in ascending order.
// (4) rational() is the root where it is a rational number, whatever its polynomial; floor and ceil are integers.
// A polynomial that is zero has every number for a root: real_roots throws InvalidShape.
// Source: RTCD 5.5; Descartes' rule with bisection (Collins and Akritas 1976), square-free parts.
// Cost: some microseconds for degrees below 7, half a second where the exponents of the coefficients span all doubles;
// linear polynomials are rational numbers.  Bounded by a fixed number of operations for each bit of the coefficients
// and each two roots, on integers of that length: 10^8 instructions a polynomial of degree four whose exponents span
// all doubles.
#pragma once

#include <compare>
#include <concepts>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plumb/arith/rational.hpp"

namespace plumb {

namespace arith {
struct IsolatedRoot;
}

class Root {
 public:
  explicit Root(const Rational& x);
  template <std::integral Integer>
  explicit Root(Integer x) : Root(Rational(x)) {}
  explicit Root(std::shared_ptr<const arith::IsolatedRoot> root) : root_(std::move(root)) {}

  friend std::strong_ordering operator<=>(const Root& a, const Root& b);
  friend bool operator==(const Root& a, const Root& b) { return (a <=> b) == std::strong_ordering::equal; }
  friend std::strong_ordering operator<=>(const Root& a, const Rational& b);
  friend bool operator==(const Root& a, const Rational& b) { return (a <=> b) == std::strong_ordering::equal; }

  [[nodiscard]] Sign sign() const;
  [[nodiscard]] double rounded(Rounding rounding = Rounding::nearest) const;
  /// The sign of another polynomial here; coefficients in ascending order.
  [[nodiscard]] Sign sign_of(std::span<const Rational> coefficients) const;

  /// The root itself, where it is a rational number.
  [[nodiscard]] std::optional<Rational> rational() const;
  /// The largest integer that is not above, the least that is not below.
  [[nodiscard]] Rational floor() const;
  [[nodiscard]] Rational ceil() const;

  /// Integers in ascending order; the polynomial has every root once.
  [[nodiscard]] std::vector<Rational> polynomial() const;
  /// Bounds between which the polynomial has no other root; equal ones are the root.
  [[nodiscard]] std::pair<Rational, Rational> interval() const;
  /// Such that are no farther apart than this, which must be above zero.
  [[nodiscard]] std::pair<Rational, Rational> interval(const Rational& width) const;

 private:
  std::shared_ptr<const arith::IsolatedRoot> root_;  // never null
};

/// All real roots; coefficients in ascending order.
std::vector<Root> real_roots(std::span<const Rational> coefficients);
/// Those from `from` to `to`, both included.
std::vector<Root> real_roots(std::span<const Rational> coefficients, const Rational& from, const Rational& to);

}  // namespace plumb
