// What are balls and tubes along a line?  The quadratics of round shapes, and the ways out of them.
//
// With w from the center to the origin, a ball is |w + t d|^2 <= r^2, whose discriminant is r^2 |d|^2 - |w x d|^2: no
// terms of degree four cancel.  About the axis e of a cylinder, in multiples of |e|^2,
//   square = |d x e|^2, half = (w x e) . (d x e), constant = |w x e|^2 - r^2 |e|^2,
//   discriminant = |e|^2 (r^2 |d x e|^2 - (w . (d x e))^2).
// Source: RTCD 5.3.2, 5.3.7.
#pragma once

#include <span>

#include "query/ray/numbers.hpp"

namespace plumb::query {

template <class T>
T length2(const Vec3<T>& v) {
  return dot(v, v);
}

template <class T>
Quadratic<T> ball_quadratic(const Vec3<T>& w, const Vec3<T>& d, double radius) {
  const T r(radius), dd = length2(d);
  return {dd, dot(w, d), length2(w) - r * r, r * r * dd - length2(cross(w, d))};
}

template <class T>
Quadratic<T> tube_quadratic(const Vec3<T>& w, const Vec3<T>& d, const Vec3<T>& e, double radius) {
  const Vec3<T> across = cross(w, e), turn = cross(d, e);
  const T r(radius), ee = length2(e), square = length2(turn), gap = dot(w, turn);
  return {square, dot(across, turn), length2(across) - r * r * ee, ee * (r * r * square - gap * gap)};
}

/// The way from the center.
template <class T>
NormalForm<T> from_center(const Vec3<T>& w, const Vec3<T>& d) {
  return {w, d, T(1.0), true};
}
/// The way from the axis: |e|^2 v - (v . e) e, over |e|^2.
template <class T>
NormalForm<T> from_axis(const Vec3<T>& w, const Vec3<T>& d, const Vec3<T>& e) {
  const T ee = length2(e);
  return {times(w, ee) - times(e, dot(w, e)), times(d, ee) - times(e, dot(d, e)), ee, true};
}

struct BallModel {
  Point3 center;
  double radius;

  static std::size_t size() { return 0; }
  template <class T>
  Linear<T> linear(const ShotLine<T>&, std::uint32_t, RaySigns&) const {
    return {T(0.0), T(0.0)};
  }
  template <class T>
  Quadratic<T> quadratic(const ShotLine<T>& line) const {
    return ball_quadratic(line.origin_from(center), line.direction, radius);
  }
  static Feature feature(std::span<const std::uint32_t>) { return {FeatureKind::face, 0}; }
  template <class T>
  NormalForm<T> normal(const ShotLine<T>& line, const Decided&, RaySigns&) const {
    return from_center(line.origin_from(center), line.direction);
  }
};

}  // namespace plumb::query
