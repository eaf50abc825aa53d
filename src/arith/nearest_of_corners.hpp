// GJK: which point of the affine hull of up to four corners is nearest to the origin, and is it within their hull?
// Over any number type.
//
// Laws: the weights add up to `whole`; over a number type whose signs are not certain the question says so, and the
// answer means nothing.
// Source: Wolfe 1976; Gilbert, Johnson and Keerthi 1988; RTCD 9.5.
// Cost: some 60 operations.
#pragma once

#include <array>

#include "arith/certain.hpp"
#include "arith/vec.hpp"

namespace plumb::arith {

template <class T>
Vec<T> no_way() {
  return {T(0.0), T(0.0), T(0.0)};
}

/// The point of the corners' affine hull that is nearest to the origin.
template <class T>
struct NearestOfCorners {
  std::array<Vec<T>, 4> at{no_way<T>(), no_way<T>(), no_way<T>(), no_way<T>()};  // the corners
  std::array<T, 4> weight{T(0.0), T(0.0), T(0.0), T(0.0)};                       // over `whole`, which is above zero
  T whole{0.0};
  Vec<T> way = no_way<T>();          // the point times what is above zero; none where it is the origin
  T square{0.0}, square_whole{1.0};  // that of its distance
  bool is_independent = true;
};

enum class Sought : unsigned char { all, square };

/// All of it, or the square of the distance alone, of corners that are proved.
template <class T, Sought sought = Sought::all>
NearestOfCorners<T> nearest_of(const std::array<Vec<T>, 4>& at, std::size_t size, CertainSigns& ask) {
  NearestOfCorners<T> n{.at = at};
  const Vec<T>& d = n.at[0];
  const T zero(0.0);
  if (size == 1) {
    n.weight[0] = n.whole = T(1.0);
    n.way = d;
    n.square = dot(d, d);
    return n;
  }
  const Vec<T> u = n.at[1] - d;
  if (size == 2) {
    n.whole = dot(u, u);
    const Vec<T> turn = cross(d, u);
    n.square = dot(turn, turn), n.square_whole = n.whole;
    if (sought == Sought::square) return n;
    n.is_independent = ask(n.whole) == Sign::positive;
    n.weight[1] = zero - dot(u, d);
    n.weight[0] = n.whole - n.weight[1];
    n.way = cross(u, turn);
    return n;
  }
  const Vec<T> v = n.at[2] - d;
  if (size == 3) {
    const Vec<T> normal = cross(u, v);
    n.whole = dot(normal, normal);
    const T height = dot(normal, d);
    n.square = height * height, n.square_whole = n.whole;
    if (sought == Sought::square) return n;
    n.is_independent = ask(n.whole) == Sign::positive;
    n.weight[1] = zero - dot(cross(d, v), normal);
    n.weight[2] = zero - dot(cross(u, d), normal);
    n.weight[0] = n.whole - n.weight[1] - n.weight[2];
    const Sign side = ask(height);
    if (side == Sign::positive) n.way = normal;
    if (side == Sign::negative) n.way = Vec<T>{zero, zero, zero} - normal;
    return n;
  }
  const Vec<T> w = n.at[3] - d;
  const Vec<T> vw = cross(v, w);
  T whole = dot(u, vw);
  const Sign turn = ask(whole);
  n.is_independent = turn != Sign::zero;
  const bool back = turn == Sign::negative;
  const auto turned = [&](const T& x) { return back ? zero - x : x; };
  n.whole = turned(whole);
  n.weight[1] = turned(zero - dot(d, vw));
  n.weight[2] = turned(zero - dot(u, cross(d, w)));
  n.weight[3] = turned(zero - dot(u, cross(v, d)));
  n.weight[0] = n.whole - n.weight[1] - n.weight[2] - n.weight[3];
  n.square = zero;
  return n;
}

/// Does the point lie within the corners' hull, and need all of them?
template <class T>
bool is_within(const NearestOfCorners<T>& n, std::size_t size, CertainSigns& ask) {
  if (!n.is_independent) return false;
  for (std::size_t i = 0; i < size; ++i) {
    if (size > 1 && ask(n.weight[i]) != Sign::positive) return false;
  }
  return true;
}

}  // namespace plumb::arith
