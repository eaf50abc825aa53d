// Vectors over any number that the methods on trial compute in; none of ours.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace plumb::lab::trial {

template <class T>
struct Vec {
  T x, y, z;

  friend Vec operator-(const Vec& a, const Vec& b) { return {T(a.x - b.x), T(a.y - b.y), T(a.z - b.z)}; }
  friend Vec operator+(const Vec& a, const Vec& b) { return {T(a.x + b.x), T(a.y + b.y), T(a.z + b.z)}; }
  friend Vec operator*(const Vec& a, const T& s) { return {T(a.x * s), T(a.y * s), T(a.z * s)}; }
};

/// Point or vector number i of a question.
template <class T, std::size_t N>
Vec<T> vec(const std::array<T, N>& q, std::size_t i) {
  return {q[3 * i], q[3 * i + 1], q[3 * i + 2]};
}
template <class T>
T dot(const Vec<T>& a, const Vec<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
Vec<T> cross(const Vec<T>& a, const Vec<T>& b) {
  return {T(a.y * b.z - a.z * b.y), T(a.z * b.x - a.x * b.z), T(a.x * b.y - a.y * b.x)};
}
template <class T>
T magnitude(const T& x) {
  return x < 0 ? T(-x) : x;
}
template <class T>
T clamped(const T& x) {
  return x < 0 ? T(0) : x > 1 ? T(1) : x;
}

/// By the library for its types; for others the nearest long double's, once improved by Newton's step.
template <class T>
T square_root(const T& x) {
  if constexpr (std::is_floating_point_v<T> && sizeof(T) <= sizeof(double)) {
    return std::sqrt(x);
  } else {
    const T guess = static_cast<T>(std::sqrt(static_cast<long double>(x)));
    return guess > 0 ? (guess + x / guess) / 2 : guess;
  }
}

template <class T>
double root_as_double(const T& square) {
  return static_cast<double>(square_root(square));
}

}  // namespace plumb::lab::trial
