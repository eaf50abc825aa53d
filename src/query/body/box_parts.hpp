// What is a pair of boxes made of, over any world of numbers: the axes' products, their edges' lengths and the way between
// their middles?
//
// Laws: everything is times two; of boxes under poses it is times both weights as well.
// Source: RTCD 4.4.1; query/body/given_box.hpp.
// Cost: some 60 operations for the way under poses.
#pragma once

#include <cstdint>

#include "arith/vec.hpp"
#include "plumb/certify/determinant_sign.hpp"
#include "plumb/certify/formula.hpp"
#include "query/body/given_box.hpp"

namespace plumb::query {

/// The entry 6 i + j holds the four of six axes that are neither i nor j.
inline constexpr auto axes_beside = [] {
  std::array<std::array<std::uint8_t, 4>, 36> all{};
  for (std::size_t of = 0; of < 36; ++of) {
    for (std::uint8_t k = 0, size = 0; k < 6 && size < 4; ++k) {
      if (k != of / 6 && k != of % 6) all[of][size++] = k;
    }
  }
  return all;
}();

/// Tells exactly, of finite vectors: equal products are rounded alike, so that a difference of zero is asked again and any
/// other is none.  Where a product is beyond doubles they may be told apart, which costs its reader a slower stage.
inline bool are_parallel(const Vector3& u, const Vector3& v) {
  const auto are_same = [](double p, double q, double r, double s) {  // the products
    if (!(p * q - r * s == 0)) return false;
    if (p == 0 || q == 0) return r == 0 || s == 0;
    return determinant_sign({std::array{p, r}, std::array{s, q}}) == Sign::zero;
  };
  return are_same(u.x, v.y, u.y, v.x) && are_same(u.y, v.z, u.z, v.y) && are_same(u.z, v.x, u.x, v.z);
}

template <class T>
arith::Vec<T> vec_of(const T& x, const T& y, const T& z) {
  return {x, y, z};
}
/// Numbers may have their errors in their types, which are not those of their products.
template <class S, class T>
auto tracked_cross(const arith::Vec<S>& u, const arith::Vec<T>& v) {
  return vec_of(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
}
template <class S, class T>
auto tracked_dot(const arith::Vec<S>& u, const arith::Vec<T>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

/// The length of an edge of a box beside another: under poses everything is times both weights.
template <class W>
auto length_beside(W& w, const GivenBox::Ends& e, const GivenBox&) {
  return w.difference(e.to, e.from);
}
template <class W>
auto length_beside(W& w, const GivenBox::Ends& e, const PosedBox& beside) {
  return w.difference(e.to, e.from) * w.template number<1>(beside.weight);
}
/// Twice the middle of p less that of q.
template <class W>
auto middle_difference(W& w, const GivenBox& p, const GivenBox& q) {
  const auto one = w.template number<1>(1);
  const auto part = [&](std::size_t k) {
    return (w.difference(p.middle[k].to, p.middle[k].from) - w.difference(q.middle[k].to, q.middle[k].from)) * one;
  };
  return vec_of(part(0), part(1), part(2));
}
template <class W>
auto middle_difference(W& w, const PosedBox& p, const PosedBox& q) {
  const auto of_p = w.template number<1>(p.weight), of_q = w.template number<1>(q.weight);
  const auto turned = [&](const PosedBox& b) {
    const auto ends = [&](std::size_t k) { return w.difference(b.local[k].to, b.local[k].from); };
    const auto x = ends(0), y = ends(1), z = ends(2);
    const auto row = [&](double u, double v, double t) {
      return w.template number<1>(u) * x + w.template number<1>(v) * y + w.template number<1>(t) * z;
    };
    const auto& [u, v, t] = b.columns;
    return vec_of(row(u.x, v.x, t.x), row(u.y, v.y, t.y), row(u.z, v.z, t.z));
  };
  const auto first = turned(p), second = turned(q);
  const auto part = [&](double to, double from, const auto& x, const auto& y) {
    const auto way = w.difference(to, from) * of_p;
    return certify::tape::doubled(way) * of_q + (x * of_q - y * of_p);
  };
  return vec_of(part(p.at.x, q.at.x, first.x, second.x), part(p.at.y, q.at.y, first.y, second.y),
                part(p.at.z, q.at.z, first.z, second.z));
}

}  // namespace plumb::query
