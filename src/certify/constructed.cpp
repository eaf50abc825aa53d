// Rounds constructed points: by pairs of doubles where they leave one nearest double only, else by integers.
#include "plumb/certify/constructed.hpp"

#include <cmath>
#include <string>

#include "plumb/arith/ball.hpp"
#include "plumb/arith/big_rounding.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/implicit.hpp"

namespace plumb {
namespace {

template <class Point>
constexpr std::span<const PointPart> parts{PointTraits<Point>::parts};

/// Cold: where the quick way leaves a choice.
template <class Point>
[[gnu::noinline]] double exact_coordinate(const Point& point, std::size_t axis) {
  const auto numbers = coordinates(point);
  mixed::require_finite({"approximate", {&parts<Point>, 1}, numbers});
  const auto h = homogeneous(point, [](double x) { return BigDyadic(x); });
  if constexpr (predicates::has_weight<KindOf<Point>>) {
    if (h.weight.sign() == Sign::zero) mixed::throw_degenerate("approximate", 'a', point);
  }
  const double x = rounded_quotient(Rounding::nearest, h.coordinate[axis], h.weight);
  if (std::isinf(x)) {
    throw BeyondDoubles(std::string("approximate: a.").append(1, "xyz"[axis]).append(" is beyond the largest double"));
  }
  return x;
}

template <class Point>
auto nearest(const Point& point) {
  using Kind = KindOf<Point>;
  const auto numbers = coordinates(point);
  std::array<double, static_cast<std::size_t>(Kind::dimension)> result;
  const auto p = [&]<std::size_t... I>(std::index_sequence<I...>) {
    const std::array<Ball, numbers.size()> balls{Ball{numbers[I]}...};
    return Kind::at(balls.data());
  }
  (std::make_index_sequence<numbers.size()>{});
  for (std::size_t axis = 0; axis < result.size(); ++axis) {
    const auto coordinate = [&] {
      if constexpr (predicates::has_weight<Kind>) {
        return p.base[axis] + quotient(p.offset[axis], p.weight);
      } else {
        return p.base[axis] + p.offset[axis];
      }
    };
    const std::optional<double> quick = coordinate().nearest();
    result[axis] = quick ? *quick : exact_coordinate(point, axis);
  }
  return result;
}

template <class Point>
Point2 nearest2(const Point& p) {
  const auto [x, y] = nearest(p);
  return {x, y};
}
template <class Point>
Point3 nearest3(const Point& p) {
  const auto [x, y, z] = nearest(p);
  return {x, y, z};
}

}  // namespace

Point2 approximate(const Point2& a) {
  mixed::require_finite({"approximate", {&parts<Point2>, 1}, coordinates(a)});
  return a;
}
Point2 approximate(const LineLinePoint2& a) { return nearest2(a); }
Point2 approximate(const SegmentPoint2& a) { return nearest2(a); }
Point2 approximate(const Posed<Point2, Pose2>& a) { return nearest2(a); }
Point3 approximate(const Point3& a) {
  mixed::require_finite({"approximate", {&parts<Point3>, 1}, coordinates(a)});
  return a;
}
Point3 approximate(const LinePlanePoint3& a) { return nearest3(a); }
Point3 approximate(const ThreePlanePoint3& a) { return nearest3(a); }
Point3 approximate(const SegmentPoint3& a) { return nearest3(a); }
Point3 approximate(const Posed<Point3>& a) { return nearest3(a); }

}  // namespace plumb
