#include "plumb/arith/rational.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "arith/big_rounding.hpp"
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

Rational quotient(const Rational& a, const Rational& b) {
  if (b.sign() == Sign::zero) throw DegeneratePoint("Rational: a quotient by zero; ask the sign of the divisor before");
  return Rational(BigRational{mpq_class(a.value().value / b.value().value)});
}

Rational whole(mpz_class x) { return Rational(BigRational{mpq_class(std::move(x))}); }

[[noreturn]] void throw_no_number(std::string_view text, const char* why) {
  constexpr std::size_t most_shown = 60;
  throw Error(std::string("Rational: \"")
                  .append(text.substr(0, most_shown))
                  .append(text.size() > most_shown ? "...\" " : "\" ")
                  .append(why));
}

/// One decimal of the text: [sign] digits [. digits] [e [sign] digits].
mpq_class decimal(std::string_view text, std::string_view whole_text) {
  constexpr int most_places = 10'000;
  constexpr const char* no_number = "is no number; give digits such as -12, 0.5, 2.5e-3, or a fraction such as -3/8";
  std::string_view rest = text;
  const auto take = [&rest](std::string_view any) {
    const bool taken = !rest.empty() && any.find(rest.front()) != std::string_view::npos;
    if (taken) rest.remove_prefix(1);
    return taken;
  };
  const bool negative = rest.starts_with('-');
  take("+-");
  std::string digits;
  long places = 0;  // behind the point
  bool behind = false;
  for (;;) {
    if (!rest.empty() && rest.front() >= '0' && rest.front() <= '9') {
      digits += rest.front();
      places += behind ? 1 : 0;
    } else if (behind || !rest.starts_with('.')) {
      break;
    } else {
      behind = true;
    }
    rest.remove_prefix(1);
  }
  if (digits.empty()) throw_no_number(whole_text, no_number);
  int power = 0;
  if (take("eE")) {
    if (take("+") && rest.starts_with('-')) throw_no_number(whole_text, no_number);
    const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), power);
    if (read.ec == std::errc::result_out_of_range || power > most_places || power < -most_places)
      throw_no_number(whole_text, "has a power of ten beyond 10,000; give a smaller one");
    if (read.ec != std::errc()) throw_no_number(whole_text, no_number);
    rest.remove_prefix(static_cast<std::size_t>(read.ptr - rest.data()));
  }
  if (!rest.empty()) throw_no_number(whole_text, no_number);
  const long tens = power - places;
  mpz_class scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(tens)));
  mpz_class number(digits, 10);
  if (negative) number = -number;
  mpq_class x = tens < 0 ? mpq_class(number, scale) : mpq_class(number * scale);
  x.canonicalize();
  return x;
}

}  // namespace

Rational::Rational(bool negative, std::uint64_t magnitude, Magnitude)
    : value_(std::make_unique<BigRational>(BigRational{mpq_class(mpz_class(magnitude))})) {
  if (negative) mpq_neg(value_->value.get_mpq_t(), value_->value.get_mpq_t());
}
Rational::Rational(const Rational& numerator, const Rational& denominator)
    : Rational(quotient(numerator, denominator)) {}

Rational Rational::from_text(std::string_view text) {
  const std::size_t bar = std::min(text.find('/'), text.size());
  const Rational numerator(BigRational{decimal(text.substr(0, bar), text)});
  if (bar == text.size()) return numerator;
  const Rational denominator(BigRational{decimal(text.substr(bar + 1), text)});
  if (denominator.sign() == Sign::zero) throw_no_number(text, "is a quotient by zero");
  return quotient(numerator, denominator);
}

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
Rational operator/(const Rational& a, const Rational& b) { return quotient(a, b); }
Rational operator-(const Rational& a) { return Rational(BigRational{mpq_class(-a.value_->value)}); }

bool operator==(const Rational& a, const Rational& b) { return a.value_->value == b.value_->value; }
std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
  return cmp(a.value_->value, b.value_->value) <=> 0;
}

Sign Rational::sign() const { return value_->sign(); }

double Rational::rounded(Rounding rounding) const { return plumb::rounded(rounding, value_->value); }

Rational Rational::numerator() const { return whole(value_->value.get_num()); }
Rational Rational::denominator() const { return whole(value_->value.get_den()); }
bool Rational::is_integer() const { return value_->value.get_den() == 1; }
Rational Rational::floor() const {
  mpz_class x;
  mpz_fdiv_q(x.get_mpz_t(), value_->value.get_num_mpz_t(), value_->value.get_den_mpz_t());
  return whole(std::move(x));
}
Rational Rational::ceil() const {
  mpz_class x;
  mpz_cdiv_q(x.get_mpz_t(), value_->value.get_num_mpz_t(), value_->value.get_den_mpz_t());
  return whole(std::move(x));
}
std::optional<std::int64_t> Rational::to_int64() const {
  static_assert(sizeof(mpz_class().get_si()) == sizeof(std::int64_t), "it comes in one word");
  if (!is_integer() || !value_->value.get_num().fits_slong_p()) return {};
  return value_->value.get_num().get_si();
}

std::string Rational::text() const { return value_->value.get_str(); }

double rounded_root(Rounding rounding, const Rational& x) {
  return rounded_root(rounding, BigDyadic(x.value().value.get_num()), BigDyadic(x.value().value.get_den()));
}

}  // namespace plumb
