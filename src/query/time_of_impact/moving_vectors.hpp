// Where are they at time t?  Vectors whose coordinates are integer polynomials of time.
//
// Laws: exact; zero is the polynomial without coefficients.
// Source: RTCD 5.5.
// Cost: an allocation a coefficient.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "arith/polynomial.hpp"
#include "plumb/arith/lattice.hpp"
#include "plumb/arith/point.hpp"

namespace plumb::query::moving {

inline arith::Polynomial trimmed(arith::Polynomial p) {
  while (!p.empty() && sgn(p.back()) == 0) p.pop_back();
  return p;
}
/// By mpz_add or mpz_sub.
template <auto combine>
arith::Polynomial combined(const arith::Polynomial& a, const arith::Polynomial& b) {
  arith::Polynomial r = a;
  if (r.size() < b.size()) r.resize(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) combine(r[i].get_mpz_t(), r[i].get_mpz_t(), b[i].get_mpz_t());
  return trimmed(std::move(r));
}
inline arith::Polynomial sum(const arith::Polynomial& a, const arith::Polynomial& b) { return combined<mpz_add>(a, b); }
inline arith::Polynomial difference(const arith::Polynomial& a, const arith::Polynomial& b) {
  return combined<mpz_sub>(a, b);
}
/// By mpz_addmul or mpz_submul.
template <auto multiply>
void take_product(arith::Polynomial& r, const arith::Polynomial& a, const arith::Polynomial& b) {
  if (a.empty() || b.empty()) return;
  if (r.size() < a.size() + b.size() - 1) r.resize(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) multiply(r[i + j].get_mpz_t(), a[i].get_mpz_t(), b[j].get_mpz_t());
  }
}
inline void add_product(arith::Polynomial& r, const arith::Polynomial& a, const arith::Polynomial& b) {
  take_product<mpz_addmul>(r, a, b);
}
inline void subtract_product(arith::Polynomial& r, const arith::Polynomial& a, const arith::Polynomial& b) {
  take_product<mpz_submul>(r, a, b);
}
inline arith::Polynomial product(const arith::Polynomial& a, const arith::Polynomial& b) {
  arith::Polynomial r;
  add_product(r, a, b);
  return r;
}

using MovingVector = std::array<arith::Polynomial, 3>;

inline MovingVector difference(const MovingVector& a, const MovingVector& b) {
  return {difference(a[0], b[0]), difference(a[1], b[1]), difference(a[2], b[2])};
}
inline MovingVector sum(const MovingVector& a, const MovingVector& b) {
  return {sum(a[0], b[0]), sum(a[1], b[1]), sum(a[2], b[2])};
}
inline arith::Polynomial dot(const MovingVector& a, const MovingVector& b) {
  arith::Polynomial r;
  for (std::size_t i = 0; i < 3; ++i) add_product(r, a[i], b[i]);
  return trimmed(std::move(r));
}
inline MovingVector cross(const MovingVector& a, const MovingVector& b) {
  const auto one = [](const arith::Polynomial& p, const arith::Polynomial& q, const arith::Polynomial& r,
                      const arith::Polynomial& s) {
    arith::Polynomial d;
    add_product(d, p, q);
    subtract_product(d, r, s);
    return trimmed(std::move(d));
  };
  return {one(a[1], b[2], a[2], b[1]), one(a[2], b[0], a[0], b[2]), one(a[0], b[1], a[1], b[0])};
}

/// x * 2^-exponent, which must be an integer.
inline mpz_class integer_on(int exponent, double x) {
  const OddForm f = odd_form(x);
  mpz_class m = static_cast<long>(f.mantissa);
  if (f.mantissa != 0) m <<= static_cast<mp_bitcnt_t>(f.exponent - exponent);
  return m;
}

inline MovingVector moving(int exponent, const Point3& from, const Point3& to) {
  const auto one = [&](double x, double y) {
    mpz_class start = integer_on(exponent, x), end = integer_on(exponent, y);
    return trimmed(arith::Polynomial{start, mpz_class(end - start)});
  };
  return {one(from.x, to.x), one(from.y, to.y), one(from.z, to.z)};
}

}  // namespace plumb::query::moving
