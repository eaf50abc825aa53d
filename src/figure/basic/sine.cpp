// One statement over intervals of doubles, and of multiples of a power of two that is as small as the angle asks.
#include "figure/basic/sine.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "plumb/arith/big.hpp"
#include "plumb/arith/rational.hpp"

namespace plumb::figure {
namespace {

Interval over(const Interval& x, unsigned n) { return quotient(x, Interval(n)); }
Interval one_like(const Interval&) { return Interval(1); }
Interval either_side(const Interval& x) {
  const double most = std::max(-x.lower, x.upper);
  return {-most, most};
}
/// A guess of where to end the series; what is left of it is enclosed.
bool is_negligible(const Interval& x) { return std::max(-x.lower, x.upper) < 0x1p-60; }

/// [lower, upper] 2^-bits; an operation moves its bounds outward to the next multiples.
struct WideInterval {
  mpz_class lower, upper;
  mp_bitcnt_t bits;

  friend WideInterval operator+(const WideInterval& a, const WideInterval& b) {
    return {a.lower + b.lower, a.upper + b.upper, a.bits};
  }
  friend WideInterval operator-(const WideInterval& a, const WideInterval& b) {
    return {a.lower - b.upper, a.upper - b.lower, a.bits};
  }
  friend WideInterval operator*(const WideInterval& a, const WideInterval& b) {
    const std::array<mpz_class, 4> all{a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper};
    const auto [least, most] = std::ranges::minmax(all);
    WideInterval x{0, 0, a.bits};
    mpz_fdiv_q_2exp(x.lower.get_mpz_t(), least.get_mpz_t(), a.bits);
    mpz_cdiv_q_2exp(x.upper.get_mpz_t(), most.get_mpz_t(), a.bits);
    return x;
  }
};
WideInterval over(const WideInterval& x, unsigned n) {
  WideInterval part{0, 0, x.bits};
  mpz_fdiv_q_ui(part.lower.get_mpz_t(), x.lower.get_mpz_t(), n);
  mpz_cdiv_q_ui(part.upper.get_mpz_t(), x.upper.get_mpz_t(), n);
  return part;
}
WideInterval one_like(const WideInterval& x) {
  const mpz_class one = mpz_class(1) << x.bits;
  return {one, one, x.bits};
}
WideInterval either_side(const WideInterval& x) {
  const mpz_class most = std::max<mpz_class>(-x.lower, x.upper);
  return {-most, most, x.bits};
}
/// A guess of where to end the series; what is left of it is enclosed.
bool is_negligible(const WideInterval& x) { return x.lower > -16 && x.upper < 16; }

template <class T>
struct Circle {
  T cosine, sine;
};

/// At a 2^doublings, where a is within [-1, 1].
template <class T>
Circle<T> circle(const T& a, int doublings) {
  T cosine = one_like(a), sine = a, term = a;
  for (unsigned n = 2; !is_negligible(term); ++n) {
    term = over(term * a, n);
    T& sum = n % 2 == 0 ? cosine : sine;
    sum = n % 4 < 2 ? sum + term : sum - term;
  }
  const T rest = either_side(term);
  cosine = cosine + rest;
  sine = sine + rest;
  for (int i = 0; i < doublings; ++i) {
    const T product = cosine * sine;
    cosine = cosine * cosine - sine * sine;
    sine = product + product;
  }
  return {cosine, sine};
}

Interval in_doubles(const WideInterval& x) {
  const auto rounded = [&](const mpz_class& bound, Rounding rounding) {
    mpq_class number(bound);
    mpq_div_2exp(number.get_mpq_t(), number.get_mpq_t(), x.bits);
    return Rational(BigRational{number}).rounded(rounding);
  };
  return {rounded(x.lower, Rounding::down), rounded(x.upper, Rounding::up)};
}

}  // namespace

CosineSine cosine_and_sine_of_half(double angle) {
  const int doublings = angle == 0 ? 0 : std::max(0, std::ilogb(angle));
  if (std::fabs(angle) < 64) {
    const auto [cosine, sine] = circle(Interval(angle) * Interval(std::ldexp(0.5, -doublings)), doublings);
    return {cosine, sine};
  }
  const auto bits = static_cast<mp_bitcnt_t>(96 + 2 * doublings);  // each doubling doubles the width, and some
  // Half of the angle over 2^doublings, which is at least 1/2 and below 1.
  const mpz_class a = mpz_class(std::ldexp(angle, 52 - doublings)) << (bits - 53);
  const auto [cosine, sine] = circle(WideInterval{a, a, bits}, doublings);
  return {in_doubles(cosine), in_doubles(sine)};
}

}  // namespace plumb::figure
