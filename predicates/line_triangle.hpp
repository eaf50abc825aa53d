// On which side of a triangle's edge does a directed line pass, and which face of the triangle does it meet?
//
// Laws: swapping a and b, or reversing the direction, flips the sign of line_edge; the three of one triangle add up to
// minus the value of orient_seen_from, exactly; zero exactly when line and edge lie in one plane (they meet, are
// parallel, or one is a point).  Moving all points by the same vector changes nothing.
// Source: RTCD 5.3.4 (scalar triple products, which are Pluecker's side products); RTCD 3.3.7.  Degree 3.
#pragma once

#include <array>
#include <string_view>

#include "plumb/predicates/cross.hpp"

namespace plumb::predicates {

/// (origin, direction, a, b): positive when the line passes the edge from a to b on its left, as seen from where the
/// line comes.  Its value by a line through two points p, q is orient3d(p, q, a, b).
struct LineEdge {
  static constexpr std::string_view name = "line_edge";
  static constexpr std::array arguments{3, 3, 3, 3};
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    return triple(argument(p, 1), difference(p, 0, 3), difference(p, 0, 2));
  }
};

/// (direction, a, b, c): positive when a, b, c turn counterclockwise for an eye far away in that direction.  Value:
/// direction . n with the normal n = (b - a) x (c - a).
struct OrientSeenFrom {
  static constexpr std::string_view name = "orient_seen_from";
  static constexpr std::array arguments{3, 3, 3, 3};
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    return triple(argument(p, 0), difference(p, 1, 2), difference(p, 1, 3));
  }
};

/// Points p, q, a, b, c: the same for the direction from p to q, which is not rounded.
struct OrientSeenAlong {
  static constexpr std::string_view name = "orient_seen_along";
  static constexpr int points = 5, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    return triple(difference(p, 0, 1), difference(p, 2, 3), difference(p, 2, 4));
  }
};

}  // namespace plumb::predicates
