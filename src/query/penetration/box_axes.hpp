// Separating axis test (SAT): is an axis of two boxes the one of fifteen along which they overlap least?  A statement
// over any world of numbers.
//
// Along n = u x v, of two of the six axes, the boxes reach sum s |n . w| over the other four, s the lengths; c is the
// way between their middles, everything times two: they overlap by that less |n . c|, over |n|.
// Laws: it is so, for certain, where no axis is as near, none has the boxes touch, and no four edges are in one plane.
// Source: RTCD 4.4.1; Gottschalk, Lin and Manocha 1996.
// Cost: some 900 operations.
#pragma once

#include "plumb/certify/certainly.hpp"
#include "query/separation/corners.hpp"

namespace plumb::query::parting {

using arith::Vec;

template <class T>
Vec<T> vec_of(const T& x, const T& y, const T& z) {
  return {x, y, z};
}
/// Of numbers whose errors are in their types, which are not those of their products.
template <class T>
auto tracked_cross(const Vec<T>& u, const Vec<T>& v) {
  return vec_of(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
}
template <class S, class T>
auto tracked_dot(const Vec<S>& u, const Vec<T>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

struct IsLeastAxis {
  static constexpr Scales scales{.count = 2, .maxima = 3};  // lengths; axes
  static constexpr int highest = 12;

  struct Told {
    bool is_least = false;
    Sign middle = Sign::zero;     // of the first less that of the second, along the normal
    std::array<Sign, 6> along{};  // what the axes lead along it
  };

  /// Of axes i < j, those of the second box after those of the first.
  template <class W>
  Told operator()(W& w, const GivenBox& a, const GivenBox& b, std::uint32_t i, std::uint32_t j) const {
    const auto axis = [&](std::size_t k) {
      const Vector3& v = (k < 3 ? a : b).axes[k % 3];
      return vec_of(w.template number<1>(v.x), w.template number<1>(v.y), w.template number<1>(v.z));
    };
    const std::array g{axis(0), axis(1), axis(2), axis(3), axis(4), axis(5)};
    const auto length = [&](std::size_t k) {
      const GivenBox::Ends& e = (k < 3 ? a : b).length[k % 3];
      return w.difference(e.to, e.from);
    };
    const std::array s{length(0), length(1), length(2), length(3), length(4), length(5)};
    const auto one = w.template number<1>(1);
    const auto middle = [&](std::size_t k) {
      const GivenBox::Ends &p = a.middle[k], &q = b.middle[k];
      return (w.difference(p.to, p.from) - w.difference(q.to, q.from)) * one;
    };
    const auto c = vec_of(middle(0), middle(1), middle(2));
    const auto of_pair = [&](std::uint32_t p, std::uint32_t q) {
      const auto n = tracked_cross(g[p], g[q]);
      const auto m = tracked_dot(n, c);
      std::array<std::size_t, 4> other{};
      for (std::size_t k = 0, size = 0; k < 6; ++k) {
        if (k != p && k != q) other[size++] = k;
      }
      const auto reach = [&](std::size_t k) { return magnitude(tracked_dot(n, g[other[k]])) * s[other[k]]; };
      const auto overlap = ((reach(0) + reach(1)) + (reach(2) + reach(3))) - magnitude(m);
      return std::tuple(n, m, overlap, overlap * overlap, tracked_dot(n, n));
    };
    Told told{true, {}, {}};
    const auto [n, m, overlap, square, length_of_n] = of_pair(i, j);
    told.middle = w.sign(m);
    for (std::uint32_t k = 0; k < 6; ++k) {
      if (k != i && k != j) told.along[k] = w.sign(tracked_dot(n, g[k]));
      told.is_least = told.is_least && (k == i || k == j || told.along[k] != Sign::zero);
    }
    told.is_least = told.is_least && told.middle != Sign::zero && w.sign(overlap) == Sign::positive;
    for (std::uint32_t p = 0; p < 6; ++p) {
      for (std::uint32_t q = p + 1; q < 6 && told.is_least; ++q) {
        if (p == i && q == j) continue;
        const auto [of_n, of_m, other, square_of_other, length_of_other] = of_pair(p, q);
        told.is_least = w.sign(other) == Sign::positive &&
                        w.compare(square * length_of_other, square_of_other * length_of_n) == Sign::negative;
      }
    }
    for (std::size_t body = 0; body < 6 && told.is_least; body += 3) {
      told.is_least = w.sign(tracked_dot(tracked_cross(g[body], g[body + 1]), g[body + 2])) != Sign::zero;
    }
    return told;
  }
};

}  // namespace plumb::query::parting
