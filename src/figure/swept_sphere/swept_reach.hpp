// How far is a point from the core of a swept sphere?  Rounded up once, for radii that certainly reach.
//
// Source: core_distance.hpp.
// Cost: pairs of doubles, 1 to 2 us; integers where they leave a doubt.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "arith/big_rounding.hpp"
#include "arith/certain.hpp"
#include "figure/swept_sphere/core_distance.hpp"
#include "plumb/arith/ball.hpp"

namespace plumb::figure::swept {

/// The point over a weight, which is positive.
template <class T>
struct Weighted {
  arith::Vec<T> point;
  T weight;
};

// From what is measured times the weight.
template <class T, class Shape>
Core<T> core_beside(const arith::Vec<T>&, const Shape& shape) {
  return core_of<T>(shape);
}
template <class T, class Shape>
Core<T> core_beside(const Weighted<T>& p, const Shape& shape) {
  return scaled(core_of<T>(shape), p.weight);
}
template <class T>
const arith::Vec<T>& place_of(const arith::Vec<T>& p) {
  return p;
}
template <class T>
const arith::Vec<T>& place_of(const Weighted<T>& p) {
  return p.point;
}
template <class T>
const T& unweighted(const arith::Vec<T>&, const T& denominator) {
  return denominator;
}
template <class T>
T unweighted(const Weighted<T>& p, const T& denominator) {
  return denominator * p.weight * p.weight;
}

template <class Point, class Shape>
std::optional<double> quick_distance_up(const Point& point, const Shape& shape) {
  CertainSigns ask;
  std::vector<Ball> squares;
  std::size_t least = 0;
  const figure::swept::Core<Ball> from{{place_of<Ball>(point)}, {}, false};
  figure::swept::visit_distances(from, core_beside<Ball>(point, shape), ask,
                                 [&](const Ball& numerator, const Ball& denominator) {
                                   squares.push_back(quotient(numerator, unweighted<Ball>(point, denominator)));
                                   if (squares.back().high < squares[least].high) least = squares.size() - 1;
                                 });
  if (!ask.certain()) return {};
  std::optional<double> result;
  for (const Ball& square : squares) {
    if ((square - squares[least]).sign() == Unsure{Sign::positive}) continue;
    const std::optional<double> r = root(square).rounded(Rounding::up);
    if (!r) return {};
    result = result ? std::min(*result, *r) : r;
  }
  return result;
}

template <class Point, class Shape>
double exact_distance_up(const Point& point, const Shape& shape) {
  CertainSigns ask;
  std::optional<std::pair<BigDyadic, BigDyadic>> least;
  const figure::swept::Core<BigDyadic> from{{place_of<BigDyadic>(point)}, {}, false};
  figure::swept::visit_distances(
      from, core_beside<BigDyadic>(point, shape), ask, [&](const BigDyadic& numerator, const BigDyadic& denominator) {
        if (!least || (numerator * least->second - least->first * denominator).sign() == Sign::negative)
          least.emplace(numerator, denominator);
      });
  return rounded_root(Rounding::up, least->first, unweighted<BigDyadic>(point, least->second));
}

/// point.template operator()<T>() makes the point over the numbers T, weighted or not; infinite beyond all doubles.
template <class Make, class Shape>
double distance_up(Make point, const Shape& shape) {
  if (const auto quick = quick_distance_up(point.template operator()<Ball>(), shape)) return *quick;
  return exact_distance_up(point.template operator()<BigDyadic>(), shape);
}

template <class Shape>
double distance_up(const Point3& p, const Shape& shape) {
  return distance_up([&]<class T>() { return arith::vec<T>(p); }, shape);
}

}  // namespace plumb::figure::swept
