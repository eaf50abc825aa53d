// Products of vectors some of whose numbers may be zero: what is times an exact zero is an exact zero.
//
// Numbers with an error bound know no product without one, for the sake of underflow.  A normal of boxes that stand
// upright is made of zeros, and whether it is at right angles to an edge is decided by them.
// Laws: the values of arith::dot, arith::cross, sums and the product with a number; a bound is no larger.
// Source: docs/proof.md.
// Cost: two comparisons a product, one a sum.
#pragma once

#include <concepts>

#include "arith/certain.hpp"
#include "arith/vec.hpp"

namespace plumb::arith {

template <class T>
[[gnu::always_inline]] inline T sparse_product(const T& a, const T& b) {
  if constexpr (requires { a.sign().certain(); }) {
    if (certainly_zero(a) || certainly_zero(b)) return T(0.0);
  }
  return a * b;
}
template <class T>
[[gnu::always_inline]] inline T sparse_sum(const T& a, const T& b) {
  if constexpr (requires { a.sign().certain(); }) {
    if (certainly_zero(b)) return a;
  }
  return a + b;
}
template <class T>
[[gnu::always_inline]] inline T sparse_difference(const T& a, const T& b) {
  if constexpr (requires { a.sign().certain(); }) {
    if (certainly_zero(b)) return a;
  }
  return a - b;
}
template <class T>
[[gnu::always_inline]] inline Vec<T> sparse_sum(const Vec<T>& a, const Vec<T>& b) {
  return {sparse_sum(a.x, b.x), sparse_sum(a.y, b.y), sparse_sum(a.z, b.z)};
}
template <class T>
[[gnu::always_inline]] inline Vec<T> sparse_difference(const Vec<T>& a, const Vec<T>& b) {
  return {sparse_difference(a.x, b.x), sparse_difference(a.y, b.y), sparse_difference(a.z, b.z)};
}
template <class T>
[[gnu::always_inline]] inline Vec<T> sparse_scaled(const Vec<T>& v, const T& by) {
  return {sparse_product(v.x, by), sparse_product(v.y, by), sparse_product(v.z, by)};
}
template <class T>
[[gnu::always_inline]] inline T sparse_dot(const Vec<T>& a, const Vec<T>& b) {
  return sparse_sum(sparse_sum(sparse_product(a.x, b.x), sparse_product(a.y, b.y)), sparse_product(a.z, b.z));
}
template <class T>
[[gnu::always_inline]] inline Vec<T> sparse_cross(const Vec<T>& a, const Vec<T>& b) {
  return {sparse_difference(sparse_product(a.y, b.z), sparse_product(a.z, b.y)),
          sparse_difference(sparse_product(a.z, b.x), sparse_product(a.x, b.z)),
          sparse_difference(sparse_product(a.x, b.y), sparse_product(a.y, b.x))};
}

}  // namespace plumb::arith
