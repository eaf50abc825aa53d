// Quadratic field: which sign has a + b sqrt(c)?  Numbers over one common root with + - *, so that a statement runs at a
// place that is the root of a quadratic polynomial.
//
// Laws: exact.  All numbers of one computation have the same c >= 0, or are plain: b = 0.  The root is named, not held:
// c outlives the numbers.
// Source: RTCD 4.3 (radii); repeated squaring, certify/radical.hpp.
// Cost: of a product five of integers, of a sign three, where the terms disagree.
#pragma once

#include "plumb/arith/big.hpp"
#include "plumb/certify/radical.hpp"

namespace plumb::certify {

/// Of a + b sqrt(c).
inline Sign sign_of_radical(const BigDyadic& a, const BigDyadic& b, const BigDyadic& c) {
  return radical::sum(a.sign(), b.sign() * c.sign(), [&] { return predicates::radical_norm(a, b, c).sign(); });
}

/// Of a + b sqrt(c) + d sqrt(e).
inline Sign sign_of_radicals(const BigDyadic& a, const BigDyadic& b, const BigDyadic& c, const BigDyadic& d,
                             const BigDyadic& e) {
  return radical::sum(sign_of_radical(a, b, c), d.sign() * e.sign(), [&] {
    const BigDyadic twice = a * b + a * b;
    return sign_of_radical(predicates::radical_pair_part(a, b, c, d, e), twice, c);
  });
}

class QuadraticNumber {
 public:
  explicit QuadraticNumber(double x) : a_(x) {}
  explicit QuadraticNumber(BigDyadic x) : a_(std::move(x)) {}
  QuadraticNumber(BigDyadic a, BigDyadic b, const BigDyadic& c) : a_(std::move(a)), b_(std::move(b)), c_(&c) {}

  [[nodiscard]] Sign sign() const { return c_ == nullptr ? a_.sign() : sign_of_radical(a_, b_, *c_); }

  friend QuadraticNumber operator+(const QuadraticNumber& x, const QuadraticNumber& y) {
    return {x.a_ + y.a_, x.b_ + y.b_, x.c_ == nullptr ? y.c_ : x.c_};
  }
  friend QuadraticNumber operator-(const QuadraticNumber& x, const QuadraticNumber& y) {
    return {x.a_ - y.a_, x.b_ - y.b_, x.c_ == nullptr ? y.c_ : x.c_};
  }
  friend QuadraticNumber operator*(const QuadraticNumber& x, const QuadraticNumber& y) {
    if (y.c_ == nullptr) return {x.a_ * y.a_, x.b_ * y.a_, x.c_};
    if (x.c_ == nullptr) return y * x;
    return {x.a_ * y.a_ + x.b_ * y.b_ * *x.c_, x.a_ * y.b_ + x.b_ * y.a_, x.c_};
  }

 private:
  QuadraticNumber(BigDyadic a, BigDyadic b, const BigDyadic* c) : a_(std::move(a)), b_(std::move(b)), c_(c) {}

  BigDyadic a_, b_;
  const BigDyadic* c_ = nullptr;  // nothing where the number is plain
};

}  // namespace plumb::certify
