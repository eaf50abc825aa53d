// When do four linearly moving points lie in one plane?  The Bernstein coefficients of that cubic.
//
// Point i is p_i at time 0 and q_i at time 1.  orient3d of the moving points is the cubic
//   b0 (1-t)^3 + 3 b1 t (1-t)^2 + 3 b2 t^2 (1-t) + b3 t^3,
// where b0 is orient3d of the p, b3 that of the q, 3 b1 the value below, and 3 b2 the same with p and q swapped.
// Laws: an even permutation of the points keeps each coefficient, an odd one flips its sign; points that do not move
// make 3 b1 three times orient3d.
// Source: RTCD 5.5 (moving objects); Provot 1997 for the cubic.  Degree 3.
#pragma once

#include <array>
#include <string_view>

#include "plumb/predicates/cross.hpp"

namespace plumb::predicates {

/// (p0, p1, p2, p3, q0, q1, q2, q3): 3 b1, the sum of the three determinants with one row of the q.
struct CoplanarityMiddle {
  static constexpr std::string_view name = "coplanarity_middle";
  static constexpr int points = 8, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 24>& p) const {
    const auto a = difference(p, 3, 0), b = difference(p, 3, 1), c = difference(p, 3, 2);
    const auto later_a = difference(p, 7, 4), later_b = difference(p, 7, 5), later_c = difference(p, 7, 6);
    return triple(later_a, b, c) + triple(later_b, c, a) + triple(later_c, a, b);
  }
};

}  // namespace plumb::predicates
