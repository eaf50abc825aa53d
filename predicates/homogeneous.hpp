// The classic predicates for points that have a weight.  Stated once for every mix of points with and without.
//
// The last point is the pivot.  All others are taken relative to its base; a pivot without a weight is subtracted as a
// whole and its row of the determinant becomes 0 ... 0 1, which vanishes when compiled: for points as given the classic
// formula is what remains.
// Laws: the value is that of the classic formula times the product of the weights (orient2d, orient3d), of their
// squares (incircle, insphere), or of both weights (order along an axis).  So its sign is the product of the signs of
// value and weights there, and that of the value alone with squares.  Swapping two points flips the sign, as for
// determinants whose rows they are.
// Source: docs/proof.md, "Weights"; RTCD 3.1.6.  Degree: one row's x, y, z and one row's weight for each column.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>
#include <utility>

#include "plumb/predicates/construction.hpp"

namespace plumb::predicates {

/// Homogeneous coordinates relative to the pivot.
template <class X, class Weight, std::size_t N>
struct Row {
  std::array<X, N> x;
  Weight w;
};

template <class Base, class Offset, class Weight, std::size_t N, class PivotOffset, class PivotWeight>
constexpr auto row(const Located<Base, Offset, Weight, N>& p, const Located<Base, PivotOffset, PivotWeight, N>& pivot) {
  const auto along = [&](std::size_t i) {
    if constexpr (std::same_as<PivotWeight, TagOne>) {
      return (p.base[i] - pivot.base[i] - pivot.offset[i]) * p.weight + p.offset[i];
    } else {
      return (p.base[i] - pivot.base[i]) * p.weight + p.offset[i];
    }
  };
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return Row<decltype(along(0)), Weight, N>{{along(I)...}, p.weight};
  }
  (std::make_index_sequence<N>{});
}

template <class Base, class Offset, class Weight, std::size_t N>
constexpr auto pivot_row(const Located<Base, Offset, Weight, N>& pivot) {
  if constexpr (std::same_as<Weight, TagOne>) {
    return Row<TagZero, TagOne, N>{};
  } else {
    return Row<Offset, Weight, N>{pivot.offset, pivot.weight};
  }
}

/// The minor of the x and y columns.
template <class P, class Q>
constexpr auto minor_xy(const P& p, const Q& q) {
  return p.x[0] * q.x[1] - p.x[1] * q.x[0];
}

/// Determinant of four rows by complementary minors: `left` of the first two columns, `right` of the last two.
template <class P, class Q, class R, class S, class Left, class Right>
constexpr auto det4_by_minors(const P& p, const Q& q, const R& r, const S& s, Left left, Right right) {
  return left(p, q) * right(r, s) - left(p, r) * right(q, s) + left(q, r) * right(p, s) +
         (left(p, s) * right(q, r) - left(q, s) * right(p, r) + left(r, s) * right(p, q));
}

struct HomogeneousOrient2d {
  static constexpr std::string_view name = "orient2d";
  static constexpr bool weights_are_squared = false;
  template <class A, class B, class C>
  constexpr auto operator()(const A& a, const B& b, const C& pivot) const {
    const auto p = row(a, pivot);
    const auto q = row(b, pivot);
    const auto s = pivot_row(pivot);
    return minor_xy(p, q) * s.w + (minor_xy(q, s) * p.w - minor_xy(p, s) * q.w);
  }
};

struct HomogeneousOrient3d {
  static constexpr std::string_view name = "orient3d";
  static constexpr bool weights_are_squared = false;
  template <class A, class B, class C, class D>
  constexpr auto operator()(const A& a, const B& b, const C& c, const D& pivot) const {
    const auto minor_zw = [](const auto& p, const auto& q) { return p.x[2] * q.w - q.x[2] * p.w; };
    const auto left = [](const auto& p, const auto& q) { return minor_xy(p, q); };
    return det4_by_minors(row(a, pivot), row(b, pivot), row(c, pivot), pivot_row(pivot), left, minor_zw);
  }
};

/// A row on the paraboloid, times the square of its weight: x w, y w, (z w,) |x|^2, w^2.
template <class X, class Weight, class Lift, class Square, std::size_t N>
struct LiftedRow {
  std::array<X, N> x;
  Weight w;
  Lift lift;
  Square square;
};

template <class X, class Weight, std::size_t N>
constexpr auto lifted(const Row<X, Weight, N>& p) {
  const auto lift = [&] {
    if constexpr (N == 2) {
      return p.x[0] * p.x[0] + p.x[1] * p.x[1];
    } else {
      return p.x[0] * p.x[0] + p.x[1] * p.x[1] + p.x[2] * p.x[2];
    }
  };
  return LiftedRow<X, Weight, decltype(lift()), decltype(p.w * p.w), N>{p.x, p.w, lift(), p.w * p.w};
}

template <class P, class Q>
constexpr auto minor_lift(const P& p, const Q& q) {
  return p.lift * q.square - q.lift * p.square;
}

struct HomogeneousInCircle {
  static constexpr std::string_view name = "incircle";
  static constexpr bool weights_are_squared = true;
  template <class A, class B, class C, class D>
  constexpr auto operator()(const A& a, const B& b, const C& c, const D& pivot) const {
    const auto left = [](const auto& p, const auto& q) { return minor_xy(p, q) * (p.w * q.w); };
    const auto right = [](const auto& p, const auto& q) { return minor_lift(p, q); };
    return det4_by_minors(lifted(row(a, pivot)), lifted(row(b, pivot)), lifted(row(c, pivot)), lifted(pivot_row(pivot)),
                          left, right);
  }
};

struct HomogeneousInSphere {
  static constexpr std::string_view name = "insphere";
  static constexpr bool weights_are_squared = true;
  template <class A, class B, class C, class D, class E>
  constexpr auto operator()(const A& a_, const B& b_, const C& c_, const D& d_, const E& pivot) const {
    const auto a = lifted(row(a_, pivot));
    const auto b = lifted(row(b_, pivot));
    const auto c = lifted(row(c_, pivot));
    const auto d = lifted(row(d_, pivot));
    const auto e = lifted(pivot_row(pivot));
    const auto ab = minor_xy(a, b);
    const auto ac = minor_xy(a, c);
    const auto ad = minor_xy(a, d);
    const auto bc = minor_xy(b, c);
    const auto bd = minor_xy(b, d);
    const auto cd = minor_xy(c, d);
    const auto ae = minor_xy(a, e);
    const auto be = minor_xy(b, e);
    const auto ce = minor_xy(c, e);
    const auto de = minor_xy(d, e);
    const auto volume = [](const auto& p, const auto& q, const auto& r, const auto& qr, const auto& pr,
                           const auto& pq) { return (r.x[2] * pq + (p.x[2] * qr - q.x[2] * pr)) * (p.w * q.w * r.w); };
    // Complementary minors: of the x, y, z columns, and of the last two.
    return (volume(a, b, c, bc, ac, ab) * minor_lift(d, e) - volume(a, b, d, bd, ad, ab) * minor_lift(c, e)) +
           (volume(a, c, d, cd, ad, ac) * minor_lift(b, e) - volume(b, c, d, cd, bd, bc) * minor_lift(a, e)) +
           (volume(a, b, e, be, ae, ab) * minor_lift(c, d) - volume(a, c, e, ce, ae, ac) * minor_lift(b, d)) +
           (volume(b, c, e, ce, be, bc) * minor_lift(a, d) + volume(a, d, e, de, ae, ad) * minor_lift(b, c)) +
           (volume(c, d, e, de, ce, cd) * minor_lift(a, b) - volume(b, d, e, de, be, bd) * minor_lift(a, c));
  }
};

/// Positive when a is beyond the pivot along an axis.
template <std::size_t Axis>
struct HomogeneousOrder {
  static constexpr std::string_view name = "compare";
  static constexpr bool weights_are_squared = false;
  template <class A, class B>
  constexpr auto operator()(const A& a, const B& pivot) const {
    const auto p = row(a, pivot);
    const auto s = pivot_row(pivot);
    return p.x[Axis] * s.w - s.x[Axis] * p.w;
  }
};

}  // namespace plumb::predicates
