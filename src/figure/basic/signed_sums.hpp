// Signed area, signed volume: what do chains and surfaces sum up to?  Twice their areas and six times their volumes,
// over any kind of number.
//
// Laws: differences are taken from the first vertex, so that far from the origin few digits cancel.
// Source: the shoelace formula; Gauss's theorem.
// Cost: linear.
#pragma once

#include <span>

#include "arith/exact_sum.hpp"
#include "plumb/arith/point.hpp"

namespace plumb::figure::signed_sums {

template <class T>
struct Vector {
  T x, y, z;

  friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vector operator*(const T& s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Maker>
using VectorOf = Vector<arith::exact_sum::Number<Maker>>;

template <class Maker, class V>
VectorOf<Maker> vector(const Maker& number, const V& v) {
  return {number(v.x), number(v.y), number(v.z)};
}
template <class Maker>
VectorOf<Maker> zero(const Maker& number) {
  return {number(0.0), number(0.0), number(0.0)};
}

/// Twice the signed area of a chain.
template <class Maker>
auto twice_area(const Maker& number, std::span<const Point2> chain) {
  using T = arith::exact_sum::Number<Maker>;
  const T x = number(chain[0].x), y = number(chain[0].y);
  T sum = number(0.0), ax = number(0.0), ay = number(0.0);
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const T bx = number(chain[i].x) - x, by = number(chain[i].y) - y;
    sum = sum + (ax * by - ay * bx);
    ax = bx;
    ay = by;
  }
  return sum;
}

/// Twice the vector area of a chain in space: normal to a planar one, counterclockwise around it.
template <class Maker, class At>
auto twice_vector_area(const Maker& number, std::size_t count, const At& at) {
  using V = VectorOf<Maker>;
  const V origin = vector(number, at(0));
  V sum = zero(number), a = sum;
  for (std::size_t i = 1; i < count; ++i) {
    const V b = vector(number, at(i)) - origin;
    sum = sum + cross(a, b);
    a = b;
  }
  return sum;
}

inline Sign area_sign(std::span<const Point2> chain) {
  return arith::exact_sum::sign([&](const auto& number) { return twice_area(number, chain); });
}

}  // namespace plumb::figure::signed_sums
