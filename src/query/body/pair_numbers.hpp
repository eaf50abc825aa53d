// Which doubles are nearest to two closest points and to their distance?  Quotients and roots, each rounded once.
//
// Laws: pairs of doubles answer where they leave one double, integers otherwise; an end is the point as it is given,
// but never -0.
// Source: docs/proof.md; RTCD 11.4.
// Cost: some 100 ns by pairs of doubles; a microsecond or two a number by integers.
#pragma once

#include <optional>

#include "arith/big_rounding.hpp"
#include "arith/certain.hpp"
#include "arith/exact_number.hpp"
#include "plumb/arith/ball.hpp"
#include "plumb/arith/rational.hpp"
#include "query/body/vectors.hpp"

namespace plumb::query {

template <class Point, class T>
using VecOf = std::conditional_t<std::is_same_v<Point, Point2>, Vec2<T>, Vec3<T>>;

/// base + along numerator / whole, whole > 0.
template <class T, class Point>
struct PointOn {
  Point base;
  VecOf<Point, T> along;
  T numerator, whole;
};

/// Two points and the square of their distance, square / square_whole.
template <class T, class Point>
struct ClosePair {
  PointOn<T, Point> a, b;
  T square, square_whole;
};

inline bool is_one(const Ball& x) { return x.high == 1 && x.low == 0 && x.radius == 0; }

inline std::optional<double> moved(double base, const Ball& along, const Ball& t) {
  return (Ball(base) + along * t).nearest();
}

inline std::optional<Point2> nearest_point(const PointOn<Ball, Point2>& p) {
  if (certainly_zero(p.numerator)) return told(p.base);
  const Ball t = quotient(p.numerator, p.whole);
  const auto x = moved(p.base.x, p.along.x, t), y = moved(p.base.y, p.along.y, t);
  if (!x || !y) return {};
  return Point2{*x, *y};
}
inline std::optional<Point3> nearest_point(const PointOn<Ball, Point3>& p) {
  if (certainly_zero(p.numerator)) return told(p.base);
  const Ball t = quotient(p.numerator, p.whole);
  const auto x = moved(p.base.x, p.along.x, t), y = moved(p.base.y, p.along.y, t), z = moved(p.base.z, p.along.z, t);
  if (!x || !y || !z) return {};
  return Point3{*x, *y, *z};
}

inline double moved(double base, const BigDyadic& along, const BigDyadic& numerator, const BigDyadic& whole) {
  return rounded_quotient(Rounding::nearest, BigDyadic(base) * whole + along * numerator, whole);
}
inline Point2 nearest_point(const PointOn<BigDyadic, Point2>& p) {
  if (p.numerator.sign() == Sign::zero) return told(p.base);
  return {moved(p.base.x, p.along.x, p.numerator, p.whole), moved(p.base.y, p.along.y, p.numerator, p.whole)};
}
inline Point3 nearest_point(const PointOn<BigDyadic, Point3>& p) {
  if (p.numerator.sign() == Sign::zero) return told(p.base);
  return {moved(p.base.x, p.along.x, p.numerator, p.whole), moved(p.base.y, p.along.y, p.numerator, p.whole),
          moved(p.base.z, p.along.z, p.numerator, p.whole)};
}

template <class Point>
std::optional<double> nearest_distance(const ClosePair<Ball, Point>& pair) {
  return root(is_one(pair.square_whole) ? pair.square : quotient(pair.square, pair.square_whole)).nearest();
}
template <class Point>
double nearest_distance(const ClosePair<BigDyadic, Point>& pair) {
  return rounded_root(Rounding::nearest, pair.square, pair.square_whole);
}

template <class Point>
Rational square_of(const ClosePair<BigDyadic, Point>& pair) {
  return exact_number(pair.square) / exact_number(pair.square_whole);
}

}  // namespace plumb::query
