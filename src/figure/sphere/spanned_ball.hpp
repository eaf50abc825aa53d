// The formulas of the ball that points span, for those who know that it exists.
#pragma once

#include <algorithm>

#include "plumb/arith/ball.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/figure/sphere/spanned_sphere.hpp"
#include "plumb/predicates/distance.hpp"
#include "plumb/predicates/in_sphere.hpp"
#include "plumb/predicates/orient.hpp"
#include "plumb/predicates/smallest_sphere.hpp"

namespace plumb::figure::sphere {

inline constexpr std::array<std::string_view, 2> from_center{"center", "p"};

/// |cp|^2.
struct SquaredDistance2 {
  static constexpr std::string_view name = "squared_distance";
  static constexpr int points = 2, dimension = 2;
  static constexpr auto argument_names = from_center;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    return predicates::squared(predicates::difference2(p, 0, 1));
  }
};
struct SquaredDistance3 {
  static constexpr std::string_view name = "squared_distance";
  static constexpr int points = 2, dimension = 3;
  static constexpr auto argument_names = from_center;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return predicates::squared(predicates::difference(p, 0, 1));
  }
};
template <class Point>
using SquaredDistance = std::conditional_t<std::is_same_v<Point, Point2>, SquaredDistance2, SquaredDistance3>;

template <class Ball>
inline constexpr int dimension = std::is_same_v<Ball, SpannedCircle2> ? 2 : 3;
template <class Ball>
using PointOf = std::conditional_t<std::is_same_v<Ball, SpannedCircle2>, Point2, Point3>;

/// Is it one of those that span the ball?
template <class Spanned>
bool spans(const Spanned& ball, const PointOf<Spanned>& p) {
  return std::find(ball.points.begin(), ball.points.begin() + ball.count, p) != ball.points.begin() + ball.count;
}

/// Positive inside, zero on the boundary; zero everywhere where the points span no ball.
inline Sign side(const SpannedCircle2& ball, const Point2& p) {
  const auto& [a, b, c] = ball.points;
  if (spans(ball, p)) return Sign::zero;
  if (ball.count == 1) return Sign::negative;
  if (ball.count == 2) return sign_of(predicates::InSmallestCircle{}, a, b, p);
  return sign_of(predicates::Orient2d{}, a, b, c) * sign_of(predicates::InCircle{}, a, b, c, p);
}
inline Sign side(const SpannedSphere3& ball, const Point3& p) {
  const auto& [a, b, c, d] = ball.points;
  if (spans(ball, p)) return Sign::zero;
  if (ball.count == 1) return Sign::negative;
  if (ball.count == 2) return sign_of(predicates::InSmallestSphere2{}, a, b, p);
  if (ball.count == 3) return sign_of(predicates::InSmallestSphere3{}, a, b, c, p);
  return sign_of(predicates::Orient3d{}, a, b, c, d) * sign_of(predicates::InSphere{}, a, b, c, d, p);
}

/// Center and squared radius to some hundred bits: what decides points that lie off the boundary by ulps.
template <class Spanned>
struct FineBall {
  std::array<Ball, static_cast<std::size_t>(dimension<Spanned>)> center;
  Ball square;

  /// Positive inside, negative outside.
  [[nodiscard]] Ball rest(const PointOf<Spanned>& p) const { return square - square_of_distance(p); }
  [[nodiscard]] Ball square_of_distance(const PointOf<Spanned>& p) const {
    const auto x = coordinates(p);
    const auto term = [&](std::size_t a) { return squared(difference(x[a], center[a])); };
    Ball sum = term(0) + term(1);
    if constexpr (dimension<Spanned> == 3) sum = sum + term(2);
    return sum;
  }
};

/// Of a ball that its points do span.
FineBall<SpannedCircle2> fine_ball(const SpannedCircle2& ball);
FineBall<SpannedSphere3> fine_ball(const SpannedSphere3& ball);

/// The center of a ball that its points do span.
Point2 center_of(const SpannedCircle2& ball);
Point3 center_of(const SpannedSphere3& ball);

}  // namespace plumb::figure::sphere
