// Vectors of any number type, of the plane and of space, so that one text serves both.
//
// Law: the cross product of vectors of the plane is the one number that is left of it, as a vector of its own; what is
// normal to the plane has no part along a vector in it.  All is inlined, so that optimizers know the constants of the
// error bounds.
// Source: RTCD 3.3.
// Cost: none.
#pragma once

#include "arith/approximate.hpp"
#include "arith/certain.hpp"
#include "arith/vec.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/big.hpp"

namespace plumb::query {

/// A point as an answer: without -0.
inline Point2 told(const Point2& p) { return {p.x + 0.0, p.y + 0.0}; }
inline Point3 told(const Point3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

using arith::cross, arith::dot;

template <class T>
using Vec3 = arith::Vec<T>;
template <class T>
struct Vec2 {
  T x, y;
  [[gnu::always_inline]] friend inline Vec2 operator+(const Vec2& a, const Vec2& b) { return {a.x + b.x, a.y + b.y}; }
  [[gnu::always_inline]] friend inline Vec2 operator-(const Vec2& a, const Vec2& b) { return {a.x - b.x, a.y - b.y}; }
  [[gnu::always_inline]] friend inline Vec2 operator*(const Vec2& a, const T& t) { return {a.x * t, a.y * t}; }
};
template <class T>
struct Normal2 {  // of the plane
  T z;
};

template <class T>
[[gnu::always_inline]] inline T dot(const Vec2<T>& a, const Vec2<T>& b) {
  return a.x * b.x + a.y * b.y;
}
template <class T>
[[gnu::always_inline]] inline T dot(const Normal2<T>& a, const Normal2<T>& b) {
  return a.z * b.z;
}
template <class T>
[[gnu::always_inline]] inline T dot(const Vec2<T>&, const Normal2<T>&) {
  return T(0.0);
}
template <class T>
[[gnu::always_inline]] inline Normal2<T> cross(const Vec2<T>& a, const Vec2<T>& b) {
  return {a.x * b.y - a.y * b.x};
}

template <class T>
[[gnu::always_inline]] inline Vec2<T> vector_of(const Point2& p) {
  return {T(p.x), T(p.y)};
}
template <class T>
[[gnu::always_inline]] inline Vec2<T> vector_of(const Vector2& p) {
  return {T(p.x), T(p.y)};
}
template <class T>
[[gnu::always_inline]] inline Vec3<T> vector_of(const Point3& p) {
  return {T(p.x), T(p.y), T(p.z)};
}
template <class T>
[[gnu::always_inline]] inline Vec3<T> vector_of(const Vector3& p) {
  return {T(p.x), T(p.y), T(p.z)};
}

/// From one point as given to another.
template <class T>
[[gnu::always_inline]] inline Vec2<T> between(const Point2& from, const Point2& to) {
  return {coordinate_difference<T>(to.x, from.x), coordinate_difference<T>(to.y, from.y)};
}
template <class T>
[[gnu::always_inline]] inline Vec3<T> between(const Point3& from, const Point3& to) {
  return {coordinate_difference<T>(to.x, from.x), coordinate_difference<T>(to.y, from.y),
          coordinate_difference<T>(to.z, from.z)};
}
template <class T>
[[gnu::always_inline]] inline Vec3<T> between(const Vec3<T>& from, const Vec3<T>& to) {
  return to - from;
}

}  // namespace plumb::query
