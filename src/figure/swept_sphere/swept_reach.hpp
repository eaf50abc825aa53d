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

template <class Shape>
std::optional<double> quick_distance_up(const arith::Vec<Ball>& point, const Shape& shape) {
  CertainSigns ask;
  std::vector<Ball> squares;
  std::size_t least = 0;
  const figure::swept::Core<Ball> from{{point}, {}, false};
  figure::swept::visit_distances(from, figure::swept::core_of<Ball>(shape), ask,
                                 [&](const Ball& numerator, const Ball& denominator) {
                                   squares.push_back(quotient(numerator, denominator));
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

template <class Shape>
double exact_distance_up(const arith::Vec<BigDyadic>& point, const Shape& shape) {
  CertainSigns ask;
  std::optional<std::pair<BigDyadic, BigDyadic>> least;
  const figure::swept::Core<BigDyadic> from{{point}, {}, false};
  figure::swept::visit_distances(
      from, figure::swept::core_of<BigDyadic>(shape), ask,
      [&](const BigDyadic& numerator, const BigDyadic& denominator) {
        if (!least || (numerator * least->second - least->first * denominator).sign() == Sign::negative)
          least.emplace(numerator, denominator);
      });
  return rounded_root(Rounding::up, least->first, least->second);
}

/// point.template operator()<T>() makes the point over the numbers T; infinite beyond all doubles.
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
