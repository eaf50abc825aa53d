#include "plumb/certify/ray_parameter.hpp"

#include "arith/rounded_radical.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/certify/radical.hpp"

namespace plumb {
namespace {

using certify::radical::sum;

/// a - sqrt(b) + sqrt(c), of which b and c are not negative.
Sign sign_of(const Rational& a, const Rational& b, const Rational& c) {
  // a - sqrt(b) first; its square, less c, is (a^2 + b - c) - 2 a sqrt(b).
  const auto first = [&] { return sum(a.sign(), -b.sign(), [&] { return (a * a - b).sign(); }); };
  return sum(first(), c.sign(), [&] {
    const Rational part = a * a + b - c, twice = a + a;
    return sum(part.sign(), -twice.sign() * b.sign(), [&] { return (part * part - twice * twice * b).sign(); });
  });
}

}  // namespace

Sign RayParameter::sign() const { return sign_of(base, square, Rational(0.0)); }

double RayParameter::rounded(Rounding rounding) const {
  if (square.sign() == Sign::zero) return base.rounded(rounding);
  // Over one denominator: (p - sqrt(r)) / q with p / q = base, r / q^2 = square.
  const mpq_class &b = base.value().value, &s = square.value().value;
  const mpz_class q = b.get_den() * s.get_den(), p = b.get_num() * s.get_den();
  const mpz_class r = s.get_num() * s.get_den() * b.get_den() * b.get_den();
  return rounded_radical(rounding, BigDyadic(p), BigDyadic(-1.0), BigDyadic(r), BigDyadic(q));
}

std::strong_ordering operator<=>(const RayParameter& a, const RayParameter& b) {
  return static_cast<int>(sign_of(a.base - b.base, a.square, b.square)) <=> 0;
}

}  // namespace plumb
