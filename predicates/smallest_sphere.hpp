// Does a point lie inside the smallest sphere (circle) through two or three others?
//
// Laws: any permutation of the points that span the sphere keeps the sign; common translation and positive scaling
// change nothing.  The sphere through two points has them as its diameter; the one through three has its center in
// their plane.  Of three collinear points there is none: zero.
// Source: RTCD 4.3, 3.1.6.4.  Degree 2 and 6.
#pragma once

#include <array>
#include <string_view>

#include "plumb/predicates/distance.hpp"

namespace plumb::predicates {

/// Positive when c is inside the circle that has the segment ab as its diameter: the angle at c is then obtuse.
struct InSmallestCircle {
  static constexpr std::string_view name = "in_smallest_circle";
  static constexpr int points = 3, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return dot(difference2(p, 2, 0), difference2(p, 1, 2));
  }
};

/// Positive when c is inside the sphere that has the segment ab as its diameter.
struct InSmallestSphere2 {
  static constexpr std::string_view name = "in_smallest_sphere2";
  static constexpr int points = 3, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& p) const {
    return dot(difference(p, 2, 0), difference(p, 1, 2));
  }
};

/// Positive when d is inside the smallest sphere through a, b, c.
///
/// With A, B, C the differences to d and n = (a - c) x (b - c), the barycentric coordinates of d's projection onto the
/// plane are (B x C) . n / n^2 and so on; the sum of A^2 times them is r^2 - |d' m|^2 + |d d'|^2 for the projection d',
/// the center m and the radius r.  What is wanted is r^2 - |d' m|^2 - |d d'|^2, and |d d'|^2 n^2 = (A . (B x C))^2.
struct InSmallestSphere3 {
  static constexpr std::string_view name = "in_smallest_sphere3";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    const auto a = difference(p, 3, 0), b = difference(p, 3, 1), c = difference(p, 3, 2);
    const auto n = cross(difference(p, 2, 0), difference(p, 2, 1));
    const auto bc = cross(b, c);
    const auto volume2 = squared(dot(a, bc));
    return squared(a) * dot(bc, n) + squared(b) * dot(cross(c, a), n) + squared(c) * dot(cross(a, b), n) -
           (volume2 + volume2);
  }
};

}  // namespace plumb::predicates
