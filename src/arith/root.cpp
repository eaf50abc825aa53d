#include "plumb/arith/root.hpp"

#include "arith/isolated_root.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/arith/error.hpp"

namespace plumb {
namespace {

using arith::IsolatedRoot, arith::Polynomial;

/// A positive multiple in integers.
Polynomial integer_polynomial(std::span<const Rational> coefficients) {
  mpz_class denominator = 1;
  for (const Rational& c : coefficients) denominator = lcm(denominator, c.value().value.get_den());
  Polynomial p;
  for (const Rational& c : coefficients) {
    const mpq_class& x = c.value().value;
    p.emplace_back(x.get_num() * (denominator / x.get_den()));
  }
  arith::make_primitive(p);
  return p;
}

Polynomial not_zero(std::span<const Rational> coefficients) {
  Polynomial p = integer_polynomial(coefficients);
  if (p.empty()) throw InvalidShape("real_roots: the polynomial is zero; give one with a coefficient that is not");
  return p;
}

std::vector<Root> held(const std::vector<IsolatedRoot>& roots) {
  std::vector<Root> all;
  all.reserve(roots.size());
  for (const IsolatedRoot& r : roots) all.emplace_back(std::make_shared<const IsolatedRoot>(r));
  return all;
}

Rational dyadic(const mpz_class& mantissa, unsigned long places) {
  return Rational(BigRational{mpq_class(mantissa, mpz_class(mpz_class(1) << places))});
}

std::pair<Rational, Rational> bounds(const IsolatedRoot& root) {
  if (root.is_rational()) {
    const Rational x(BigRational{root.rational()});
    return {x, x};
  }
  return {dyadic(root.lower, root.places), dyadic(root.upper, root.places)};
}

}  // namespace

Root::Root(const Rational& x) : root_(std::make_shared<const IsolatedRoot>(arith::root_at(x.value().value))) {}

std::strong_ordering operator<=>(const Root& a, const Root& b) {
  if (a.root_ == b.root_) return std::strong_ordering::equal;
  return arith::compare(*a.root_, *b.root_) <=> 0;
}

std::strong_ordering operator<=>(const Root& a, const Rational& b) {
  return arith::compare(*a.root_, b.value().value) <=> 0;
}

Sign Root::sign() const { return sign_of_number(arith::compare(*root_, mpq_class(0))); }

double Root::rounded(Rounding rounding) const { return arith::rounded(rounding, *root_); }

Sign Root::sign_of(std::span<const Rational> coefficients) const {
  IsolatedRoot root = *root_;
  return sign_of_number(arith::sign_at(integer_polynomial(coefficients), root));
}

std::vector<Rational> Root::polynomial() const {
  std::vector<Rational> coefficients;
  for (const mpz_class& c : root_->polynomial) coefficients.emplace_back(BigRational{mpq_class(c)});
  return coefficients;
}

std::optional<Rational> Root::rational() const {
  IsolatedRoot root = *root_;
  const auto x = arith::rational_value(root);
  return x ? std::optional(Rational(BigRational{*x})) : std::nullopt;
}

// An interval no longer than one holds one integer at most within it.
Rational Root::floor() const {
  const Rational x = interval(1).second.floor();
  return *this < x ? x - 1 : x;
}
Rational Root::ceil() const {
  const Rational x = interval(1).first.ceil();
  return *this > x ? x + 1 : x;
}

std::pair<Rational, Rational> Root::interval() const { return bounds(*root_); }

std::pair<Rational, Rational> Root::interval(const Rational& width) const {
  if (width.sign() != Sign::positive)
    throw Error("Root: interval: the width is " + width.text() + "; give one above zero");
  IsolatedRoot root = *root_;
  arith::refine(root, width.value().value);
  return bounds(root);
}

std::vector<Root> real_roots(std::span<const Rational> coefficients) {
  return held(arith::isolated_roots(not_zero(coefficients)));
}

std::vector<Root> real_roots(std::span<const Rational> coefficients, const Rational& from, const Rational& to) {
  return held(arith::isolated_roots(not_zero(coefficients), from.value().value, to.value().value));
}

}  // namespace plumb
