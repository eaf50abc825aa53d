// Which of two points is farther from a line, from which of two lines is a point farther, and is it within a distance?
//
// Laws, and the form of the values: predicates/distance.hpp.
// Source: RTCD 5.1.2.1.  Degree 2 to 6.
#pragma once

#include <array>
#include <string_view>

#include "plumb/predicates/distance.hpp"

namespace plumb::predicates {

/// Signed distances from the line ab, positive to its left: that of c against that of d.
struct SignedLineDistance {
  static constexpr std::string_view name = "signed_line_distance";
  static constexpr int points = 4, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& p) const {
    return cross(difference2(p, 0, 1), difference2(p, 3, 2));
  }
};

/// The sum of these signed distances: with their difference it compares their magnitudes.
struct LineDistanceSum {
  static constexpr std::string_view name = "line_distance_sum";
  static constexpr int points = 4, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& p) const {
    return cross(difference2(p, 0, 1), difference2(p, 0, 2) + difference2(p, 0, 3));
  }
};

/// Distances from the line ab in space: that of c against that of d.
struct CompareLineDistance {
  static constexpr std::string_view name = "compare_line_distance";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    const auto ab = difference(p, 0, 1);
    return dot(cross(ab, difference(p, 3, 2)), cross(ab, difference(p, 0, 2) + difference(p, 0, 3)));
  }
};

/// The distance of c from the line ab against |d|, for a number d.
struct LineDistanceAgainst2d {
  static constexpr std::string_view name = "line_distance_against2d";
  static constexpr std::array arguments{2, 2, 2, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 7>& p) const {
    const auto ab = difference2(p, 0, 1);
    return squared(cross(ab, difference2(p, 0, 2))) - squared(p[6]) * squared(ab);
  }
};

struct LineDistanceAgainst3d {
  static constexpr std::string_view name = "line_distance_against3d";
  static constexpr std::array arguments{3, 3, 3, 1};
  template <class T>
  constexpr auto operator()(const std::array<T, 10>& p) const {
    const auto ab = difference(p, 0, 1);
    return squared(cross(ab, difference(p, 0, 2))) - squared(p[9]) * squared(ab);
  }
};

/// |ab| against the distance of e from the line cd.
struct ComparePointLine2d {
  static constexpr std::string_view name = "compare_point_line2d";
  static constexpr int points = 5, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 10>& p) const {
    const auto cd = difference2(p, 2, 3);
    return squared(difference2(p, 0, 1)) * squared(cd) - squared(cross(cd, difference2(p, 2, 4)));
  }
};

struct ComparePointLine3d {
  static constexpr std::string_view name = "compare_point_line3d";
  static constexpr int points = 5, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 15>& p) const {
    const auto cd = difference(p, 2, 3);
    return squared(difference(p, 0, 1)) * squared(cd) - squared(cross(cd, difference(p, 2, 4)));
  }
};

/// The distance of c from the line ab against that of f from the line de.
struct CompareLineLine2d {
  static constexpr std::string_view name = "compare_line_line2d";
  static constexpr int points = 6, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    const auto ab = difference2(p, 0, 1), de = difference2(p, 3, 4);
    return squared(cross(ab, difference2(p, 0, 2))) * squared(de) -
           squared(cross(de, difference2(p, 3, 5))) * squared(ab);
  }
};

struct CompareLineLine3d {
  static constexpr std::string_view name = "compare_line_line3d";
  static constexpr int points = 6, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 18>& p) const {
    const auto ab = difference(p, 0, 1), de = difference(p, 3, 4);
    return squared(cross(ab, difference(p, 0, 2))) * squared(de) -
           squared(cross(de, difference(p, 3, 5))) * squared(ab);
  }
};

}  // namespace plumb::predicates
