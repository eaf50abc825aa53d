// Vectors of three numbers: differences of points, dot, cross and scalar triple products, over any number type.
//
// Laws: cross(u, v) == -cross(v, u), zero exactly when u and v are parallel or one is zero; triple keeps its value
// under cyclic permutation and flips its sign when two vectors are swapped.
// Source: RTCD 3.3.3, 3.3.5, 3.3.7.
// Cost: dot 3 products, cross 6, triple 9.
#pragma once

#include <array>
#include <cstddef>

#include "plumb/predicates/standard.hpp"

namespace plumb::predicates {

/// The numbers of a formula differ in type: a coordinate as given is not of the type of a difference.
template <class T>
struct Triple {
  T x, y, z;
};
template <class T>
Triple(T, T, T) -> Triple<T>;

/// Argument number i of a formula whose first arguments are points and vectors.
template <class T, std::size_t N>
constexpr auto argument(const std::array<T, N>& p, std::size_t i) {
  return Triple{p[3 * i], p[3 * i + 1], p[3 * i + 2]};
}

/// From argument number `from` to argument number `to`.
template <class T, std::size_t N>
constexpr auto difference(const std::array<T, N>& p, std::size_t from, std::size_t to) {
  return Triple{p[3 * to] - p[3 * from], p[3 * to + 1] - p[3 * from + 1], p[3 * to + 2] - p[3 * from + 2]};
}

template <class T, class U>
constexpr auto operator+(const Triple<T>& u, const Triple<U>& v) {
  return Triple{u.x + v.x, u.y + v.y, u.z + v.z};
}

template <class T, class U>
constexpr auto operator-(const Triple<T>& u, const Triple<U>& v) {
  return Triple{u.x - v.x, u.y - v.y, u.z - v.z};
}

template <class T, class U>
constexpr auto scaled(const Triple<T>& u, const U& by) {
  return Triple{u.x * by, u.y * by, u.z * by};
}

template <class T, class U>
constexpr auto dot(const Triple<T>& u, const Triple<U>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

template <class T, class U>
constexpr auto cross(const Triple<T>& u, const Triple<U>& v) {
  return Triple{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// u . (v x w), the determinant of the rows u, v, w.
template <class T, class U, class V>
constexpr auto triple(const Triple<T>& u, const Triple<U>& v, const Triple<V>& w) {
  return dot(u, cross(v, w));
}

}  // namespace plumb::predicates
