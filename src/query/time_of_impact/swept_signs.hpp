// Continuous collision detection: on which side is what moves?  Bernstein coefficients of products of differences.
//
// Over any world (certify/world.hpp): the cubic that is zero when four points are in one plane, times 6, and the sides
// of a figure's projections along the axes, quadratics, times 2; of the whole time, and of a piece of it.
// Laws: every coefficient is a polynomial of the coordinates, whose error doubles derive from this text alone; each
// axis has a scale of its own.  A coefficient of a piece is between those of the whole.
// Source: RTCD 5.5; polar forms: Farouki 2012; docs/proof.md, "Tracked errors".
// Cost: that of the plain operations, and three maxima for a difference.
#pragma once

#include <array>
#include <utility>

#include "plumb/arith/point.hpp"
#include "plumb/certify/certainly.hpp"

namespace plumb::query::moving {

/// The largest difference along each axis.
inline constexpr Scales swept_scales{.count = 3, .maxima = 7};
template <class Listener = NoBoundListener>
using SweptFloats = certify::one_lane::Floats<double, 3, swept_scales, Listener>;

template <class X, class Y, class Z>
struct SweptVector {
  X x;
  Y y;
  Z z;
};
template <class X, class Y, class Z>
SweptVector(X, Y, Z) -> SweptVector<X, Y, Z>;

/// A vector that moves linearly.
template <class V>
struct Swept {
  V at_0, at_1;
};
template <class V>
Swept(V, V) -> Swept<V>;

/// From a to b.
template <class W>
auto swept_difference(W& w, const Point3& b, const Point3& a) {
  return SweptVector{w.template difference<0>(b.x, a.x), w.template difference<1>(b.y, a.y),
                     w.template difference<2>(b.z, a.z)};
}

/// As an array, of which all have the type that either has.
template <class A, class B>
auto of_one_type(const A& first, const B& second, const A& third) {
  return std::array{select(true, first, second), select(true, second, first), select(true, third, second)};
}
template <class A, class B>
auto of_one_type(const A& first, const B& second, const B& third, const A& fourth) {
  return std::array{select(true, first, second), select(true, second, first), select(true, third, first),
                    select(true, fourth, second)};
}

/// Twice the cross product of two vectors that move.
template <class V>
auto swept_side(const Swept<V>& a, const Swept<V>& b) {
  const auto along = [&](auto p, auto q) {
    const auto one = [&](const V& s, const V& t) { return s.*p * (t.*q) - s.*q * (t.*p); };
    return of_one_type(twice(one(a.at_0, b.at_0)), one(a.at_0, b.at_1) + one(a.at_1, b.at_0),
                       twice(one(a.at_1, b.at_1)));
  };
  return SweptVector{along(&V::y, &V::z), along(&V::z, &V::x), along(&V::x, &V::y)};
}

/// Six times the determinant of three vectors that move, two of them as their side.
template <class V, class Side>
auto swept_cubic(const Swept<V>& a, const Side& side) {
  const auto dot = [&](const V& d, std::size_t i) { return d.x * side.x[i] + d.y * side.y[i] + d.z * side.z[i]; };
  const auto thrice = [](const auto& x) { return twice(x) + x; };
  return of_one_type(thrice(dot(a.at_0, 0)), twice(dot(a.at_0, 1)) + dot(a.at_1, 0),
                     twice(dot(a.at_1, 1)) + dot(a.at_0, 2), thrice(dot(a.at_1, 2)));
}

/// The polar form of a quadratic, whose values at the ends of a piece of time are the coefficients there.
template <class N>
auto polar(const N& a, const N& b, const N& c, double s, double t) {
  return between(between(a, b, s), between(b, c, s), t);
}
template <class N>
auto piece_of(const std::array<N, 3>& q, double s, double t) {
  return std::array{polar(q[0], q[1], q[2], s, s), polar(q[0], q[1], q[2], s, t), polar(q[0], q[1], q[2], t, t)};
}
template <class N>
auto piece_of(const std::array<N, 4>& b, double s, double t) {
  const auto at = [&](double r) {
    return std::array{between(b[0], b[1], r), between(b[1], b[2], r), between(b[2], b[3], r)};
  };
  const auto first = at(s), last = at(t);
  return std::array{polar(first[0], first[1], first[2], s, s), polar(first[0], first[1], first[2], s, t),
                    polar(first[0], first[1], first[2], t, t), polar(last[0], last[1], last[2], t, t)};
}

}  // namespace plumb::query::moving
