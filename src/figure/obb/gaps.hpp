// Separating axis test, error bounds: how far off may doubles be that tell how oriented boxes lie?  The gaps along all
// axes as formulas, and their bounds.
//
// The matrix of a box's cofactors (its rows are the box's face normals n_i) maps it to an axis-aligned one, and another
// parallelepiped to one of its kind, and separating axes to separating axes.  There the fifteen axes cost nearly what
// they do for orthonormal ones, but no axes need be orthonormal: every gap is a polynomial's value times a square.
// Laws: a gap that is computed in doubles, its sums in whatever order, is off by no more than its bound: a constant
// that is derived from the formula (certify/formula.hpp), times powers of the largest coordinate of a's axes, of b's,
// and of what lies between the centers.
// Source: RTCD 4.4.1, table 4.1.
// Cost: none; figure/obb/quick.cpp computes them.
#pragma once

#include <algorithm>

#include "plumb/certify/detail/filter_stage.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/predicates/cross.hpp"

namespace plumb::figure::obb_gaps {

using predicates::cross;
using predicates::dot;
using predicates::Triple;

/// The arguments of every gap: ca, cb, a's axes, b's axes, a's half extents, b's.
struct Shape {
  static constexpr std::array arguments{3, 3, 3, 3, 3, 3, 3, 3, 3, 3};
  static constexpr std::array<std::string_view, 10> argument_names{"a.center",  "b.center",  "a.axes[0]", "a.axes[1]",
                                                                   "a.axes[2]", "b.axes[0]", "b.axes[1]", "b.axes[2]",
                                                                   "a.half",    "b.half"};
  static constexpr bool homogeneous = false;
  // The numbers before these are points, then come axes, then half extents.
  static constexpr std::size_t axes_from = 6, half_a_from = 24, half_b_from = 27;
};
template <class T>
using Boxes = std::array<T, 30>;
template <class T>
constexpr auto axis_of_a(const Boxes<T>& p, std::size_t i) {
  return predicates::argument(p, 2 + i % 3);
}
template <class T>
constexpr auto axis_of_b(const Boxes<T>& p, std::size_t j) {
  return predicates::argument(p, 5 + j % 3);
}

/// The absolute value in a bound: that of the value, for | |v| - |V| | <= |v - V|.
template <class T>
constexpr T size(const T& x) {
  return x;
}

/// A vector of b in the frame of a, one coordinate of each of b's axes in turn.
template <class B, class N>
constexpr auto row(const B& b0, const B& b1, const B& b2, const N& normal) {
  return Triple{dot(b0, normal), dot(b1, normal), dot(b2, normal)};
}
template <class K, class R>
constexpr auto reach(const Triple<K>& k, const Triple<R>& r) {
  return k.x * size(r.x) + k.y * size(r.y) + k.z * size(r.z);
}
/// Along one of a's face normals: t and h are a's frame's distance of the centers and half extent.
template <class T, class H, class R, class K>
constexpr auto face_gap_of_a(const T& t, const H& h, const Triple<R>& n, const Triple<K>& k) {
  return size(t) - (h + reach(k, n));
}
/// Along a's axis i times each of b's: i1 and i2 are the other two axes, c = n1 x n2.
template <class T, class H, class R, class C, class K>
constexpr auto edge_gaps(const T& t1, const T& t2, const H& h1, const H& h2, const Triple<R>& n1, const Triple<R>& n2,
                         const Triple<C>& c, const Triple<K>& k) {
  return Triple{
      size(t2 * n1.x - t1 * n2.x) - ((h1 * size(n2.x) + h2 * size(n1.x)) + (k.y * size(c.z) + k.z * size(c.y))),
      size(t2 * n1.y - t1 * n2.y) - ((h1 * size(n2.y) + h2 * size(n1.y)) + (k.z * size(c.x) + k.x * size(c.z))),
      size(t2 * n1.z - t1 * n2.z) - ((h1 * size(n2.z) + h2 * size(n1.z)) + (k.x * size(c.y) + k.y * size(c.x)))};
}
/// Along b's face normals: c[i] is row i of the cofactors of n.
template <class T, class H, class C, class D, class K>
constexpr auto face_gaps_of_b(const Triple<T>& t, const Triple<H>& h, const Triple<C>& c0, const Triple<C>& c1,
                              const Triple<C>& c2, const D& determinant, const Triple<K>& k) {
  const auto d = size(determinant);
  return Triple{
      size(t.x * c0.x + t.y * c1.x + t.z * c2.x) - (k.x * d + (h.x * size(c0.x) + h.y * size(c1.x) + h.z * size(c2.x))),
      size(t.x * c0.y + t.y * c1.y + t.z * c2.y) - (k.y * d + (h.x * size(c0.y) + h.y * size(c1.y) + h.z * size(c2.y))),
      size(t.x * c0.z + t.y * c1.z + t.z * c2.z) -
          (k.z * d + (h.x * size(c0.z) + h.y * size(c1.z) + h.z * size(c2.z)))};
}

/// What all gaps have in common, over any number type.
template <class T>
struct Frame {
  const Boxes<T>& p;
  constexpr auto between() const { return predicates::difference(p, 0, 1); }
  constexpr auto normal(std::size_t i) const { return cross(axis_of_a(p, i + 1), axis_of_a(p, i + 2)); }
  constexpr auto t(std::size_t i) const { return dot(between(), normal(i)); }
  constexpr auto h(std::size_t i) const { return p[24 + i % 3] * size(dot(axis_of_a(p, 0), normal(0))); }
  constexpr auto n(std::size_t i) const { return row(axis_of_b(p, 0), axis_of_b(p, 1), axis_of_b(p, 2), normal(i)); }
  constexpr auto c(std::size_t i) const { return cross(n(i + 1), n(i + 2)); }
  constexpr auto k() const { return predicates::argument(p, 9); }
};

/// Along the first axis of space.
struct AxisOfSpace : Shape {
  static constexpr std::string_view name = "relate";
  template <class T>
  constexpr auto operator()(const Boxes<T>& p) const {
    const auto reach_along = [&](std::size_t axes, std::size_t half) {
      return reach(predicates::argument(p, half), Triple{p[3 * axes], p[3 * axes + 3], p[3 * axes + 6]});
    };
    return size(p[3] - p[0]) - (reach_along(2, 8) + reach_along(5, 9));
  }
};
struct FaceOfA : Shape {
  static constexpr std::string_view name = "relate";
  template <class T>
  constexpr auto operator()(const Boxes<T>& p) const {
    const Frame<T> f{p};
    return face_gap_of_a(f.t(0), f.h(0), f.n(0), f.k());
  }
};
/// The center of b inside a: below zero for each of three.
struct CenterInA : Shape {
  static constexpr std::string_view name = "relate";
  template <class T>
  constexpr auto operator()(const Boxes<T>& p) const {
    const Frame<T> f{p};
    return size(f.t(0)) - f.h(0);
  }
};
struct EdgePair : Shape {
  static constexpr std::string_view name = "relate";
  template <class T>
  constexpr auto operator()(const Boxes<T>& p) const {
    const Frame<T> f{p};
    return edge_gaps(f.t(1), f.t(2), f.h(1), f.h(2), f.n(1), f.n(2), f.c(0), f.k()).x;
  }
};
struct FaceOfB : Shape {
  static constexpr std::string_view name = "relate";
  template <class T>
  constexpr auto operator()(const Boxes<T>& p) const {
    const Frame<T> f{p};
    return face_gaps_of_b(Triple{f.t(0), f.t(1), f.t(2)}, Triple{f.h(0), f.h(1), f.h(2)}, f.c(0), f.c(1), f.c(2),
                          dot(f.n(0), f.c(0)), f.k())
        .x;
  }
};

/// Of an axis-aligned box a and b, twice as far apart and twice as large: min, max, cb, b's axes, b's half extents.
struct BoxShape {
  static constexpr std::array arguments{3, 3, 3, 3, 3, 3, 3};
  static constexpr std::string_view name = "relate";
  static constexpr bool homogeneous = false;
  static constexpr std::size_t axes_from = 9, half_a_from = 18, half_b_from = 18;
};
template <class T>
struct BoxFrame {
  const std::array<T, 21>& p;
  constexpr auto t(std::size_t i) const { return (p[6 + i % 3] - p[i % 3]) + (p[6 + i % 3] - p[3 + i % 3]); }
  constexpr auto h(std::size_t i) const { return p[3 + i % 3] - p[i % 3]; }
  constexpr auto n(std::size_t i) const { return Triple{p[9 + i % 3], p[12 + i % 3], p[15 + i % 3]}; }
  constexpr auto c(std::size_t i) const { return cross(n(i + 1), n(i + 2)); }
  constexpr auto k() const { return Triple{p[18] + p[18], p[19] + p[19], p[20] + p[20]}; }
};
struct FaceOfBox : BoxShape {
  template <class T>
  constexpr auto operator()(const std::array<T, 21>& p) const {
    const BoxFrame<T> f{p};
    return face_gap_of_a(f.t(0), f.h(0), f.n(0), f.k());
  }
};
struct EdgeOfBox : BoxShape {
  template <class T>
  constexpr auto operator()(const std::array<T, 21>& p) const {
    const BoxFrame<T> f{p};
    return edge_gaps(f.t(1), f.t(2), f.h(1), f.h(2), f.n(1), f.n(2), f.c(0), f.k()).x;
  }
};
struct FaceBesideBox : BoxShape {
  template <class T>
  constexpr auto operator()(const std::array<T, 21>& p) const {
    const BoxFrame<T> f{p};
    return face_gaps_of_b(Triple{f.t(0), f.t(1), f.t(2)}, Triple{f.h(0), f.h(1), f.h(2)}, f.c(0), f.c(1), f.c(2),
                          dot(f.n(0), f.c(0)), f.k())
        .x;
  }
};

/// The magnitude of the gap for points, half extents of a and of b as given, all axes of ones.
template <class F>
consteval double terms(double points, double half_a, double half_b) {
  std::array<LargestMagnitude::Input, arity<F>> p;
  for (std::size_t i = 0; i < p.size(); ++i)
    p[i] = {i < F::axes_from ? points : i < F::half_a_from ? 1 : i < F::half_b_from ? half_a : half_b};
  return LargestMagnitude(F{}(p)).magnitude;
}

/// The gap's error is at most this times largest(a)^x largest(b)^y (largest(d) + the sum of half_a largest(a) + that of
/// half_b largest(b)), with x and y the degrees in the axes of what is multiplied by d: the magnitude has no larger
/// coefficient, and what is multiplied by a half extent has an axis of its own more.  Twice the filter's constant pays
/// for another order of the sums, for products that are not rounded, and for the dozen roundings of that product.
template <class F>
inline constexpr double error = [] {
  const double most = std::max({terms<F>(1, 0, 0), terms<F>(0, 1, 0), terms<F>(0, 0, 1)});
  return 2 * filter_constant<F>() * most;
}();

}  // namespace plumb::figure::obb_gaps
