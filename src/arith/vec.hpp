// Vectors of space over any number type with + - *.
//
// All is inlined, so that optimizers know the constants of the error bounds that numbers carry.
// Source: RTCD 3.3.
// Cost: none.
#pragma once

#include "plumb/arith/point.hpp"

namespace plumb::arith {

template <class T>
struct Vec {
  T x, y, z;
  [[gnu::always_inline]] friend inline Vec operator+(const Vec& a, const Vec& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  [[gnu::always_inline]] friend inline Vec operator-(const Vec& a, const Vec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  [[gnu::always_inline]] friend inline Vec operator*(const Vec& a, const T& t) { return {a.x * t, a.y * t, a.z * t}; }
};
using Plain = Vec<double>;

template <class T>
[[gnu::always_inline]] inline T dot(const Vec<T>& a, const Vec<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
[[gnu::always_inline]] inline Vec<T> cross(const Vec<T>& a, const Vec<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The same of doubles as given; of the plane z = 0 where there is no z.
template <class T>
[[gnu::always_inline]] inline Vec<T> vec(const Point3& p) {
  return {T(p.x), T(p.y), T(p.z)};
}
template <class T>
[[gnu::always_inline]] inline Vec<T> vec(const Vector3& v) {
  return {T(v.x), T(v.y), T(v.z)};
}
template <class T>
[[gnu::always_inline]] inline Vec<T> vec(const Plain& v) {
  return {T(v.x), T(v.y), T(v.z)};
}
template <class T>
[[gnu::always_inline]] inline Vec<T> vec(const Point2& p) {
  return {T(p.x), T(p.y), T(0.0)};
}
template <class T>
[[gnu::always_inline]] inline Vec<T> vec(const Vector2& v) {
  return {T(v.x), T(v.y), T(0.0)};
}

}  // namespace plumb::arith
