// Where is an exact point, in integers?  What its cache keeps once doubles could not tell.
//
// Laws: the point is at / weight; at and weight are integers without a common factor, weight > 0.  So two points are
// equal exactly where these numbers are.
// Cost: about that of the point's construction over integers, and of their greatest common divisor.
#pragma once

#include <algorithm>
#include <memory>

#include "certify/exact_coordinates.hpp"

namespace plumb::certify {

template <std::size_t N>
struct ExactPlace {
  certify::meeting::Weighted<BigDyadic, N> point;
  mutable std::atomic<std::size_t> owners{1};

  explicit ExactPlace(certify::meeting::Weighted<BigDyadic, N> p) : point(std::move(p)) {}
};

template <std::size_t N>
const ExactPlace<N>* shared(const ExactPlace<N>* place) {
  place->owners.fetch_add(1, std::memory_order_relaxed);
  return place;
}
template <std::size_t N>
void release(const ExactPlace<N>* place) {
  if (place->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) delete place;
}

/// The same point; of a weight that is not zero.
template <std::size_t N>
certify::meeting::Weighted<BigDyadic, N> primitive(const certify::meeting::Weighted<BigDyadic, N>& p) {
  std::array<const BigDyadic*, N + 1> from;
  std::array<mpz_class, N + 1> x;
  for (std::size_t i = 0; i < N; ++i) from[i] = &p.at[i];
  from[N] = &p.weight;
  long least = p.weight.exponent();
  for (const BigDyadic* n : from) {
    if (n->sign() != Sign::zero) least = std::min(least, n->exponent());
  }
  mpz_class factor = 0;
  for (std::size_t i = 0; i <= N; ++i) {
    if (from[i]->sign() != Sign::zero)
      x[i] = from[i]->mantissa() << static_cast<mp_bitcnt_t>(from[i]->exponent() - least);
    factor = gcd(factor, x[i]);
  }
  if (p.weight.sign() == Sign::negative) factor = -factor;
  certify::meeting::Weighted<BigDyadic, N> result;
  for (std::size_t i = 0; i <= N; ++i) {
    mpz_divexact(x[i].get_mpz_t(), x[i].get_mpz_t(), factor.get_mpz_t());
    (i < N ? result.at[i] : result.weight) = BigDyadic(std::move(x[i]));
  }
  return result;
}

template <std::size_t N>
bool are_equal(const certify::meeting::Weighted<BigDyadic, N>& p, const certify::meeting::Weighted<BigDyadic, N>& q) {
  bool equal = (p.weight - q.weight).sign() == Sign::zero;
  for (std::size_t i = 0; i < N; ++i) equal = equal && (p.at[i] - q.at[i]).sign() == Sign::zero;
  return equal;
}

}  // namespace plumb::certify
