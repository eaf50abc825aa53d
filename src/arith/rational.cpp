#include "plumb/arith/rational.hpp"

#include <cmath>
#include <utility>

#include "plumb/arith/big_rounding.hpp"
#include "plumb/arith/error.hpp"

namespace plumb {
namespace {

BigRational finite(double x) {
  if (!std::isfinite(x))
    throw NonFinite(std::string("Rational: ").append(std::isnan(x) ? "nan" : "inf").append(" is not a real number"));
  return big_rational(x);
}

BigRational canonical(BigRational x) {
  x.value.canonicalize();
  return x;
}

}  // namespace

Rational::Rational(double x) : value_(std::make_unique<BigRational>(finite(x))) {}
Rational::Rational(BigRational x) : value_(std::make_unique<BigRational>(canonical(std::move(x)))) {}
Rational::Rational(const Rational& other) : value_(std::make_unique<BigRational>(*other.value_)) {}
Rational::Rational(Rational&& other) noexcept = default;
Rational& Rational::operator=(const Rational& other) {
  if (this != &other) value_ = std::make_unique<BigRational>(*other.value_);
  return *this;
}
Rational& Rational::operator=(Rational&& other) noexcept = default;
Rational::~Rational() = default;

Rational operator+(const Rational& a, const Rational& b) { return Rational(*a.value_ + *b.value_); }
Rational operator-(const Rational& a, const Rational& b) { return Rational(*a.value_ - *b.value_); }
Rational operator*(const Rational& a, const Rational& b) { return Rational(*a.value_ * *b.value_); }
Rational operator/(const Rational& a, const Rational& b) {
  if (b.sign() == Sign::zero) throw DegeneratePoint("Rational: a quotient by zero; ask the sign of the divisor before");
  return Rational(BigRational{mpq_class(a.value_->value / b.value_->value)});
}
Rational operator-(const Rational& a) { return Rational(BigRational{mpq_class(-a.value_->value)}); }

bool operator==(const Rational& a, const Rational& b) { return a.value_->value == b.value_->value; }
std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  return cmp(a.value_->value, b.value_->value) <=> 0;
}

Sign Rational::sign() const { return value_->sign(); }

double Rational::rounded(Rounding rounding) const { return plumb::rounded(rounding, value_->value); }

std::string Rational::text() const { return value_->value.get_str(); }

double rounded_root(Rounding rounding, const Rational& x) {
  return rounded_root(rounding, BigDyadic(x.value().value.get_num()), BigDyadic(x.value().value.get_den()));
}

}  // namespace plumb
