// On which side of a line or a plane does a point lie?
//
// Laws: swapping two points flips the sign; an even permutation keeps it; zero exactly when the points are collinear
// (coplanar); moving all points by the same vector, or scaling them by the same positive number, changes nothing.
// Source: RTCD 3.1.6.1, 3.1.6.2.  Degree 2 and 3.
#pragma once

#include <array>
#include <string_view>

#include "plumb/predicates/determinant.hpp"

namespace plumb::predicates {

/// Positive when a, b, c turn counterclockwise.  Value: twice the signed area.
struct Orient2d {
  static constexpr std::string_view name = "orient2d";
  static constexpr int points = 3, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return det2(p[0] - p[4], p[1] - p[5],  //
                p[2] - p[4], p[3] - p[5]);
  }
};

/// Positive when d lies below the plane of a, b, c, where 'above' sees them counterclockwise.  Value: six times the
/// signed volume.
struct Orient3d {
  static constexpr std::string_view name = "orient3d";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    return det3(p[0] - p[9], p[1] - p[10], p[2] - p[11],  //
                p[3] - p[9], p[4] - p[10], p[5] - p[11],  //
                p[6] - p[9], p[7] - p[10], p[8] - p[11]);
  }
};

}  // namespace plumb::predicates
