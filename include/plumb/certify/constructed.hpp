// Where is an implicit or posed point?  The nearest doubles, or its exact homogeneous coordinates.
//
// Laws: every coordinate of approximate(p) is the double nearest to the exact one, ties to even, rounded once; a point
// as given is returned as it is.  Zero is never -0.  homogeneous(p, make) has p's exact coordinates, times its weight,
// in whatever numbers `make` makes of doubles.
// The approximation is for eyes and files.  What must be decided about the point is decided about the point itself
// (certify/implicit.hpp).
// Source: RTCD 5.1.9.1, 5.3.1, 5.4.5; Ziv 1991.
// Cost: below 1 us; some us where pairs of doubles cannot tell.
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "plumb/arith/ball.hpp"
#include "plumb/certify/detail/point_kind.hpp"

namespace plumb {

/// Throws DegeneratePoint where there is no point, BeyondDoubles where a coordinate is beyond the largest double (by
/// half an ulp or more), NonFinite; all name the argument `a`.
Point2 approximate(const Point2& a);
Point2 approximate(const LineLinePoint2& a);
Point2 approximate(const SegmentPoint2& a);
Point2 approximate(const Posed<Point2, Pose2>& a);
Point3 approximate(const Point3& a);
Point3 approximate(const LinePlanePoint3& a);
Point3 approximate(const ThreePlanePoint3& a);
Point3 approximate(const SegmentPoint3& a);
Point3 approximate(const Posed<Point3>& a);

/// What is known of an implicit point in doubles.
template <std::size_t N>
struct NearestDoubles {
  std::array<double, N> at;      // infinite where the coordinate is beyond all doubles
  std::array<bool, N> is_exact;  // the coordinate is that double, as far as it is seen at once
};

/// As approximate, but a coordinate beyond all doubles is infinite; what is thrown names the question and its argument.
NearestDoubles<2> nearest_doubles(std::string_view question, char argument, const LineLinePoint2& point);
NearestDoubles<2> nearest_doubles(std::string_view question, char argument, const SegmentPoint2& point);
NearestDoubles<3> nearest_doubles(std::string_view question, char argument, const LinePlanePoint3& point);
NearestDoubles<3> nearest_doubles(std::string_view question, char argument, const ThreePlanePoint3& point);
NearestDoubles<3> nearest_doubles(std::string_view question, char argument, const SegmentPoint3& point);

/// Pairs of doubles and how far off the coordinates may be; infinitely where nothing is known.
std::array<Ball, 2> coordinate_balls(const LineLinePoint2& point);
std::array<Ball, 2> coordinate_balls(const SegmentPoint2& point);
std::array<Ball, 3> coordinate_balls(const LinePlanePoint3& point);
std::array<Ball, 3> coordinate_balls(const ThreePlanePoint3& point);
std::array<Ball, 3> coordinate_balls(const SegmentPoint3& point);

/// The point coordinate / weight; the weight is zero where a construction has no point.
template <class Number, std::size_t N>
struct Homogeneous {
  std::array<Number, N> coordinate;
  Number weight;
};

/// The exact homogeneous coordinates over the numbers that make(double) gives, which need + - * (no expression
/// templates: GMP's classes must be wrapped).
template <class Point, class Make>
constexpr auto homogeneous(const Point& point, Make make) {
  using Kind = KindOf<Point>;
  const auto numbers = coordinates(point);
  using Number = decltype(make(numbers[0]));
  constexpr auto dimension = static_cast<std::size_t>(Kind::dimension);
  const auto p = [&]<std::size_t... I>(std::index_sequence<I...>) {
    const std::array<Number, numbers.size()> made{make(numbers[I])...};
    return Kind::at(made.data());
  }
  (std::make_index_sequence<numbers.size()>{});
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    const auto weight = [&]() -> Number {
      if constexpr (predicates::has_weight<Kind>) {
        return p.weight;
      } else {
        return make(1.0);
      }
    };
    return Homogeneous<Number, dimension>{{p.base[I] * p.weight + p.offset[I]...}, weight()};
  }
  (std::make_index_sequence<dimension>{});
}

}  // namespace plumb
