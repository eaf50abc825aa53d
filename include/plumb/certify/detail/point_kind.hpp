// Which kind of point is this, and which numbers is it made of?  What the signs of implicit points know of each type.
//
// Laws: coordinates(point) are the numbers in the order of the kind (predicates/construction.hpp); `parts` names them
// in the same order, as a user would write them after the point.  A further kind of point is one more PointTraits, and
// one more overload of `coordinates`.
// Source: docs/implicit_points.md.
// Cost: none.
#pragma once

#include <array>
#include <concepts>
#include <string_view>

#include "plumb/arith/implicit_point.hpp"
#include "plumb/arith/point.hpp"
#include "plumb/arith/pose.hpp"
#include "plumb/certify/sign_of.hpp"
#include "plumb/predicates/construction.hpp"

namespace plumb {

constexpr std::array<double, 8> coordinates(const LineLinePoint2& p) {
  return {p.a.x, p.a.y, p.b.x, p.b.y, p.c.x, p.c.y, p.d.x, p.d.y};
}
constexpr std::array<double, 15> coordinates(const LinePlanePoint3& p) {
  return {p.p.x, p.p.y, p.p.z, p.q.x, p.q.y, p.q.z, p.a.x, p.a.y, p.a.z, p.b.x, p.b.y, p.b.z, p.c.x, p.c.y, p.c.z};
}
constexpr std::array<double, 27> coordinates(const ThreePlanePoint3& p) {
  std::array<double, 27> all{};
  std::size_t i = 0;
  for (const auto* plane : {&p.first, &p.second, &p.third}) {
    for (const Point3& point : *plane) {
      for (const double x : {point.x, point.y, point.z}) all[i++] = x;
    }
  }
  return all;
}
constexpr std::array<double, 5> coordinates(const SegmentPoint2& p) { return {p.a.x, p.a.y, p.b.x, p.b.y, p.t}; }
constexpr std::array<double, 7> coordinates(const SegmentPoint3& p) {
  return {p.a.x, p.a.y, p.a.z, p.b.x, p.b.y, p.b.z, p.t};
}
constexpr std::array<double, 8> coordinates(const Posed<Point2, Pose2>& p) {
  const auto& [c, t] = p.pose;
  return {p.shape.x, p.shape.y, c[0].x, c[0].y, c[1].x, c[1].y, t.x, t.y};
}
constexpr std::array<double, 15> coordinates(const Posed<Point3>& p) {
  const auto& [c, t] = p.pose;
  return {p.shape.x, p.shape.y, p.shape.z, c[0].x, c[0].y, c[0].z, c[1].x, c[1].y,
          c[1].z,    c[2].x,    c[2].y,    c[2].z, t.x,    t.y,    t.z};
}

/// Numbers of a point that a message names together.
struct PointPart {
  std::string_view name;
  int numbers;
};

template <class Point>
struct PointTraits {};

template <>
struct PointTraits<Point2> {
  using Kind = predicates::ExplicitKind2;
  static constexpr std::array parts{PointPart{"", 2}};
};
template <>
struct PointTraits<Point3> {
  using Kind = predicates::ExplicitKind3;
  static constexpr std::array parts{PointPart{"", 3}};
};
template <>
struct PointTraits<LineLinePoint2> {
  using Kind = predicates::LineLineKind2;
  static constexpr std::array parts{PointPart{".a", 2}, PointPart{".b", 2}, PointPart{".c", 2}, PointPart{".d", 2}};
};
template <>
struct PointTraits<LinePlanePoint3> {
  using Kind = predicates::LinePlaneKind3;
  static constexpr std::array parts{PointPart{".p", 3}, PointPart{".q", 3}, PointPart{".a", 3}, PointPart{".b", 3},
                                    PointPart{".c", 3}};
};
template <>
struct PointTraits<ThreePlanePoint3> {
  using Kind = predicates::ThreePlaneKind3;
  static constexpr std::array parts{PointPart{".first[0]", 3},  PointPart{".first[1]", 3},  PointPart{".first[2]", 3},
                                    PointPart{".second[0]", 3}, PointPart{".second[1]", 3}, PointPart{".second[2]", 3},
                                    PointPart{".third[0]", 3},  PointPart{".third[1]", 3},  PointPart{".third[2]", 3}};
};
template <>
struct PointTraits<SegmentPoint2> {
  using Kind = predicates::SegmentKind2;
  static constexpr std::array parts{PointPart{".a", 2}, PointPart{".b", 2}, PointPart{".t", 1}};
};
template <>
struct PointTraits<SegmentPoint3> {
  using Kind = predicates::SegmentKind3;
  static constexpr std::array parts{PointPart{".a", 3}, PointPart{".b", 3}, PointPart{".t", 1}};
};
template <>
struct PointTraits<Posed<Point2, Pose2>> {
  using Kind = predicates::PosedKind2;
  static constexpr std::array parts{PointPart{".shape", 2}, PointPart{".pose.columns[0]", 2},
                                    PointPart{".pose.columns[1]", 2}, PointPart{".pose.translation", 2}};
};
template <>
struct PointTraits<Posed<Point3>> {
  using Kind = predicates::PosedKind3;
  static constexpr std::array parts{PointPart{".shape", 3}, PointPart{".pose.columns[0]", 3},
                                    PointPart{".pose.columns[1]", 3}, PointPart{".pose.columns[2]", 3},
                                    PointPart{".pose.translation", 3}};
};

template <class Point>
using KindOf = typename PointTraits<Point>::Kind;

/// A point in the plane, as given, constructed or posed.
template <class Point>
concept AnyPoint2 = requires {
  typename KindOf<Point>;
}
&&KindOf<Point>::dimension == 2;

/// A point in space, likewise.
template <class Point>
concept AnyPoint3 = requires {
  typename KindOf<Point>;
}
&&KindOf<Point>::dimension == 3;

template <class... Points>
concept SomeImplicit = ((!std::same_as<Points, Point2> && !std::same_as<Points, Point3>) || ...);

}  // namespace plumb
