// Ray cast, floating-point filter: what do doubles prove of a ray against a triangle, and a box?  The formulas whose
// constants the filters take.
//
// With the corners A, B, C seen from the origin and the direction d, the line passes the edge from P to Q at
// d . (Q x P), positive on its left; the plane is met at t = N / D with N = A . (B x C), D = -(sum of the three).
// Every product is at most that of the largest coordinates in its axes: one magnitude serves all three edges.
#pragma once

#include <array>
#include <string_view>

#include "plumb/arith/filtered.hpp"
#include "plumb/certify/formula.hpp"
#include "plumb/predicates/line_triangle.hpp"

namespace plumb::query {

/// (origin, a, b, c): A . (C x B), minus the numerator of t.
struct PlaneAhead {
  static constexpr std::string_view name = "hits";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    using namespace predicates;
    return triple(difference(p, 0, 1), difference(p, 0, 3), difference(p, 0, 2));
  }
};
/// (p, q, a, b): the side of the edge ab on which the line from p through q passes, which is the same volume.
using SegmentEdge = PlaneAhead;
/// (p, q, a, b, c): N - D of the line from p through q.
struct PlaneBehindEnd {
  static constexpr std::string_view name = "hits";
  static constexpr int points = 5, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    using namespace predicates;
    const auto d = difference(p, 0, 1), a = difference(p, 0, 2), b = difference(p, 0, 3), c = difference(p, 0, 4);
    const auto bc = cross(c, b);
    return ((dot(d, cross(b, a)) + dot(d, bc)) + dot(d, cross(a, c))) - dot(a, bc);
  }
};

/// Of the side of an edge, whether the direction is given or a rounded difference.
inline constexpr double edge_constant = filter_constant<predicates::LineEdge>() > filter_constant<SegmentEdge>()
                                            ? filter_constant<predicates::LineEdge>()
                                            : filter_constant<SegmentEdge>();

/// Twice the largest product, and an eighth for the roundings of the magnitude itself.
inline constexpr double magnitude_slack = 2.125;
/// More than all guards that the products of a formula add.
inline constexpr double guard_inside = 0x1p-960, guard = 0x1p-960;

}  // namespace plumb::query
