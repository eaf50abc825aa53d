#include "plumb/certify/ray_parameter.hpp"

#include "arith/rounded_radical.hpp"
#include "plumb/arith/big.hpp"
#include "plumb/certify/radical.hpp"

namespace plumb {
namespace {

using certify::radical::sum;

/// A root, taken once or minus once; the number below it is not negative.
struct Term {
  const Rational& square;
  Sign sign;  // zero of a root of zero
};
Term root_of(const RayParameter& t) {
  const Sign root = t.square.sign();
  return {t.square, t.greater ? root : -root};
}

/// a + root + other.
Sign sign_of(const Rational& a, const Term& root, const Term& other) {
  // a + root first; its square, less that of the other, is (a^2 + b - c) + 2 a root.
  const Rational &b = root.square, &c = other.square;
  const auto first = [&] { return sum(a.sign(), root.sign, [&] { return (a * a - b).sign(); }); };
  return sum(first(), other.sign, [&] {
    const Rational part = a * a + b - c, twice = a + a;
    return sum(part.sign(), twice.sign() * root.sign, [&] { return (part * part - twice * twice * b).sign(); });
  });
}

}  // namespace

Sign RayParameter::sign() const {
  return sum(base.sign(), root_of(*this).sign, [this] { return (base * base - square).sign(); });
}

double RayParameter::rounded(Rounding rounding) const {
  if (square.sign() == Sign::zero) return base.rounded(rounding);
  // Over one denominator: (p -+ sqrt(r)) / q with p / q = base, r / q^2 = square.
  const mpq_class &b = base.value().value, &s = square.value().value;
  const mpz_class q = b.get_den() * s.get_den(), p = b.get_num() * s.get_den();
  const mpz_class r = s.get_num() * s.get_den() * b.get_den() * b.get_den();
  return rounded_radical(rounding, BigDyadic(p), BigDyadic(greater ? 1.0 : -1.0), BigDyadic(r), BigDyadic(q));
}

std::strong_ordering operator<=>(const RayParameter& a, const RayParameter& b) {
  return static_cast<int>(sign_of(a.base - b.base, root_of(a), {b.square, -root_of(b).sign})) <=> 0;
}

}  // namespace plumb
