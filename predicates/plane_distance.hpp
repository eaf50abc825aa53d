// On which side of a plane is a point, how far from it, and is that farther than another distance?
//
// A plane is given by three points, or by a normal and an offset: the points x with normal . x = offset.
// Laws, and the form of the values: predicates/distance.hpp.  Of a normal and an offset the terms differ in degree:
// only scaling both by the same number changes nothing.
// Source: RTCD 3.6, 5.1.1.  Degree 2 to 10.
#pragma once

#include <array>
#include <string_view>

#include "plumb/predicates/distance.hpp"

namespace plumb::predicates {

/// (normal, offset, point): positive on the side of the line to which the normal points.
struct SideOfLine {
  static constexpr std::string_view name = "side_of_line";
  static constexpr std::array arguments{2, 1, 2};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 5>& p) const {
    return p[0] * p[3] + p[1] * p[4] - p[2];
  }
};

struct SideOfPlane {
  static constexpr std::string_view name = "side_of_plane";
  static constexpr std::array arguments{3, 1, 3};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 7>& p) const {
    return p[0] * p[4] + p[1] * p[5] + p[2] * p[6] - p[3];
  }
};

/// (normal, offset, point, number): the distance from the line against the magnitude of the number.
struct NormalDistanceAgainst2d {
  static constexpr std::string_view name = "normal_distance_against2d";
  static constexpr std::array arguments{2, 1, 2, 1};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return squared(p[0] * p[3] + p[1] * p[4] - p[2]) - squared(p[5]) * (squared(p[0]) + squared(p[1]));
  }
};

struct NormalDistanceAgainst3d {
  static constexpr std::string_view name = "normal_distance_against3d";
  static constexpr std::array arguments{3, 1, 3, 1};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& p) const {
    return squared(p[0] * p[4] + p[1] * p[5] + p[2] * p[6] - p[3]) -
           squared(p[7]) * (squared(p[0]) + squared(p[1]) + squared(p[2]));
  }
};

/// Signed distances from the plane abc, positive on the side that sees a, b, c counterclockwise: that of d against that
/// of e.
struct SignedPlaneDistance {
  static constexpr std::string_view name = "signed_plane_distance";
  static constexpr int points = 5, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    return triple(difference(p, 4, 3), difference(p, 0, 1), difference(p, 0, 2));
  }
};

/// The sum of these signed distances: with their difference it compares their magnitudes.
struct PlaneDistanceSum {
  static constexpr std::string_view name = "plane_distance_sum";
  static constexpr int points = 5, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    return triple(difference(p, 0, 3) + difference(p, 0, 4), difference(p, 0, 1), difference(p, 0, 2));
  }
};

/// The distance of d from the plane abc against |e|, for a number e.
struct PlaneDistanceAgainst {
  static constexpr std::string_view name = "plane_distance_against";
  static constexpr std::array arguments{3, 3, 3, 3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 13>& p) const {
    const auto n = cross(difference(p, 0, 1), difference(p, 0, 2));
    return squared(dot(difference(p, 0, 3), n)) - squared(p[12]) * squared(n);
  }
};

/// |ab| against the distance of f from the plane cde.
struct ComparePointPlane {
  static constexpr std::string_view name = "compare_point_plane";
  static constexpr int points = 6, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& p) const {
    const auto n = cross(difference(p, 2, 3), difference(p, 2, 4));
    return squared(difference(p, 0, 1)) * squared(n) - squared(dot(difference(p, 2, 5), n));
  }
};

/// The distance of c from the line ab against that of g from the plane def.
struct CompareLinePlane {
  static constexpr std::string_view name = "compare_line_plane";
  static constexpr int points = 7, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 21>& p) const {
    const auto ab = difference(p, 0, 1);
    const auto n = cross(difference(p, 3, 4), difference(p, 3, 5));
    return squared(cross(ab, difference(p, 0, 2))) * squared(n) - squared(dot(difference(p, 3, 6), n)) * squared(ab);
  }
};

/// The distance of d from the plane abc against that of h from the plane efg.
struct ComparePlanePlane {
  static constexpr std::string_view name = "compare_plane_plane";
  static constexpr int points = 8, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 24>& p) const {
    const auto m = cross(difference(p, 0, 1), difference(p, 0, 2));
    const auto n = cross(difference(p, 4, 5), difference(p, 4, 6));
    return squared(dot(difference(p, 0, 3), m)) * squared(n) - squared(dot(difference(p, 4, 7), n)) * squared(m);
  }
};

}  // namespace plumb::predicates
