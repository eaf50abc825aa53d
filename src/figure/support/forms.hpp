// Support mapping: what of a round shape lies farthest?  Its exact feature, and the point as K + W / sqrt(D) in any
// kind of number.
//
// Laws: numbers are finite and radii not negative; who calls has looked.  D is zero only where W is to be left out.
// Cost: the signs that choose the feature.
#pragma once

#include "arith/radial_number.hpp"
#include "figure/support/input.hpp"
#include "plumb/figure/basic/round.hpp"

namespace plumb::figure::support {

using arith::exact_sum::Number;
using figure::signed_sums::cross;
using figure::signed_sums::dot;
using figure::signed_sums::vector;
using figure::signed_sums::VectorOf;

struct Choice {
  std::uint32_t feature;
  bool unique;
  bool round;  // is there something to add to the core: W / sqrt(D)?
};

Choice choose(const Sphere3& s, const Vector3& d);
Choice choose(const Capsule3& s, const Vector3& d);
Choice choose(const Lozenge3& s, const Vector3& d);
Choice choose(const Cylinder3& s, const Vector3& d);
Choice choose(const Cone3& s, const Vector3& d);
Choice choose(const Ellipsoid3& s, const Vector3& d);

/// The chosen point of the core: a center, an end, a corner.
template <class M>
VectorOf<M> core(const M& number, const Sphere3& s, const Choice&) {
  return vector(number, s.center);
}
template <class M>
VectorOf<M> core(const M& number, const Capsule3& s, const Choice& c) {
  return vector(number, c.feature == 0 ? s.a : s.b);
}
template <class M>
VectorOf<M> core(const M& number, const Lozenge3& s, const Choice& c) {
  VectorOf<M> sum = vector(number, s.corner);
  if ((c.feature & 1) != 0) sum = sum + vector(number, s.edges[0]);
  if ((c.feature & 2) != 0) sum = sum + vector(number, s.edges[1]);
  return sum;
}
template <class M>
VectorOf<M> core(const M& number, const Cylinder3& s, const Choice& c) {
  return vector(number, c.feature == 0 ? s.a : s.b);
}
template <class M>
VectorOf<M> core(const M& number, const Cone3& s, const Choice& c) {
  return vector(number, c.feature == 0 ? s.apex : s.base);
}
template <class M>
VectorOf<M> core(const M& number, const Ellipsoid3& s, const Choice&) {
  return vector(number, s.center);
}

/// From the core on: w / sqrt(d).
template <class T>
struct Rest {
  figure::signed_sums::Vector<T> w;
  T d;
};

template <class M>
Rest<Number<M>> toward(const M& number, double radius, const VectorOf<M>& d) {
  return {number(radius) * d, dot(d, d)};
}

/// In the plane perpendicular to the axis from a to b.
template <class M>
Rest<Number<M>> across(const M& number, double radius, const Point3& a, const Point3& b, const VectorOf<M>& d) {
  const VectorOf<M> u = vector(number, b) - vector(number, a), w = cross(cross(u, d), u);
  return {number(radius) * w, dot(w, w)};
}

template <class M>
Rest<Number<M>> rest(const M& number, const Sphere3& s, const VectorOf<M>& d) {
  return toward(number, s.radius, d);
}
template <class M>
Rest<Number<M>> rest(const M& number, const Capsule3& s, const VectorOf<M>& d) {
  return toward(number, s.radius, d);
}
template <class M>
Rest<Number<M>> rest(const M& number, const Lozenge3& s, const VectorOf<M>& d) {
  return toward(number, s.radius, d);
}
template <class M>
Rest<Number<M>> rest(const M& number, const Cylinder3& s, const VectorOf<M>& d) {
  return s.a == s.b ? toward(number, s.radius, d) : across(number, s.radius, s.a, s.b, d);
}
template <class M>
Rest<Number<M>> rest(const M& number, const Cone3& s, const VectorOf<M>& d) {
  return s.apex == s.base ? toward(number, s.radius, d) : across(number, s.radius, s.apex, s.base, d);
}
template <class M>
Rest<Number<M>> rest(const M& number, const Ellipsoid3& s, const VectorOf<M>& d) {
  const std::array<double, 3> half{s.half.x, s.half.y, s.half.z};
  Rest<Number<M>> sum{figure::signed_sums::zero(number), number(0.0)};
  for (std::size_t i = 0; i < 3; ++i) {
    const VectorOf<M> axis = number(half[i]) * vector(number, s.axes[i]);
    const Number<M> g = dot(axis, d);
    sum.w = sum.w + g * axis;
    sum.d = sum.d + g * g;
  }
  return sum;
}

/// One number of the answer: `take` makes a number of a vector, its coordinate or its product with the direction.
template <class Shape, class Take>
double rounded(Rounding rounding, const Shape& shape, const Vector3& d, const Choice& c, const Take& take) {
  return arith::radial::rounded(rounding, [&](const auto& number) {
    using T = Number<std::decay_t<decltype(number)>>;
    const auto k = core(number, shape, c);
    if (!c.round) return arith::radial::Parts<T>{take(number, k), number(0.0), number(1.0)};
    const auto r = rest(number, shape, vector(number, d));
    return arith::radial::Parts<T>{take(number, k), take(number, r.w), r.d};
  });
}

}  // namespace plumb::figure::support
