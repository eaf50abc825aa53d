// Linear span: which vectors of space are combinations of those seen?
//
// Laws: exact.
// Source: none.
// Cost: GMP; a product or two a vector.
#pragma once

#include <gmpxx.h>

#include "arith/vec.hpp"

namespace plumb::query {

/// Of vectors of mpq_class or mpz_class.
template <class Number>
class Span {
 public:
  using Vector = arith::Vec<Number>;

  [[nodiscard]] bool holds(const Vector& v) const {
    if (rank_ == 0) return is_zero(v);
    if (rank_ == 1) return is_zero(arith::cross(first_, v));
    return rank_ == 3 || sgn(arith::dot(normal_, v)) == 0;
  }
  void add(const Vector& v) {
    if (holds(v)) return;
    if (rank_ == 0) first_ = v;
    if (rank_ == 1) normal_ = arith::cross(first_, v);
    ++rank_;
  }

  static bool is_zero(const Vector& v) { return sgn(v.x) == 0 && sgn(v.y) == 0 && sgn(v.z) == 0; }

 private:
  int rank_ = 0;
  Vector first_{0, 0, 0}, normal_{0, 0, 0};
};

}  // namespace plumb::query
