// What sign has a product of cross products?  Angles between planes, and positions along a common perpendicular.
//
// Laws: swapping the two factors of a cross product flips the sign; zero whenever a cross product is the zero vector
// (parallel or zero factors), exactly.
// Source: RTCD 3.3.6 (Lagrange's identity, the triple cross product), 4.4.2.  Degree 4 and 3.
#pragma once

#include <array>
#include <string_view>

#include "plumb/predicates/cross.hpp"

namespace plumb::predicates {

/// Vectors a, b, c, d: (a x b) . (c x d).
struct DotOfCrosses {
  static constexpr std::string_view name = "dot_of_crosses";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    return dot(cross(argument(p, 0), argument(p, 1)), cross(argument(p, 2), argument(p, 3)));
  }
};

/// Points a, b, c, d: ((b - a) x (c - a)) . ((b - a) x (d - a)), positive when c and d lie on the same side of the line
/// ab in their plane.
struct CoplanarSide {
  static constexpr std::string_view name = "coplanar_side";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    const auto ab = difference(p, 0, 1);
    return dot(cross(ab, difference(p, 0, 2)), cross(ab, difference(p, 0, 3)));
  }
};

/// (vector u, vector v, point p, point q): (u x v) . (q - p), positive when q lies further than p along u x v.
struct OrderAlongCross {
  static constexpr std::string_view name = "order_along_cross";
  static constexpr std::array arguments{3, 3, 3, 3};
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    return triple(difference(p, 2, 3), argument(p, 0), argument(p, 1));
  }
};

}  // namespace plumb::predicates
