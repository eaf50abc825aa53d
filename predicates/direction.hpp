// How do two directions lie to one another, and which of two points comes first along one?
//
// A direction is a vector as given, or the difference of two points.
// Laws: a dot product keeps its sign when its factors are swapped, a cross product flips it; negating one factor flips
// both; common translation of points and positive scaling of anything change nothing.
// Source: RTCD 3.3.3, 3.3.5.  Degree 1 and 2.
#pragma once

#include <array>
#include <string_view>

#include "plumb/predicates/determinant.hpp"
#include "plumb/predicates/orient.hpp"

namespace plumb::predicates {

template <class T>
constexpr auto dot2(const T& ax, const T& ay, const T& bx, const T& by) {
  return ax * bx + ay * by;
}

template <class T, class U>
constexpr auto dot3(const T& ax, const T& ay, const T& az, const U& bx, const U& by, const U& bz) {
  return ax * bx + ay * by + az * bz;
}

/// Of two numbers: positive when the first is the larger.
struct OrderOnAxis {
  static constexpr std::string_view name = "order_on_axis";
  static constexpr int points = 2, dimension = 1;
  template <class T>
  constexpr auto operator()(const std::array<T, 2>& p) const {
    return p[0] - p[1];
  }
};

/// Positive when a lies farther along the direction c than b does.
struct OrderAlongDirection2d {
  static constexpr std::string_view name = "order_along_direction2d";
  static constexpr int points = 3, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return (p[0] - p[2]) * p[4] + (p[1] - p[3]) * p[5];
  }
};

struct OrderAlongDirection3d {
  static constexpr std::string_view name = "order_along_direction3d";
  static constexpr int points = 3, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& p) const {
    return (p[0] - p[3]) * p[6] + (p[1] - p[4]) * p[7] + (p[2] - p[5]) * p[8];
  }
};

/// Positive when a lies farther along the line from c to d than b does.
struct OrderAlongLine2d {
  static constexpr std::string_view name = "order_along_line2d";
  static constexpr int points = 4, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 8>& p) const {
    return dot2(p[0] - p[2], p[1] - p[3], p[6] - p[4], p[7] - p[5]);
  }
};

struct OrderAlongLine3d {
  static constexpr std::string_view name = "order_along_line3d";
  static constexpr int points = 4, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 12>& p) const {
    return dot3(p[0] - p[3], p[1] - p[4], p[2] - p[5], p[9] - p[6], p[10] - p[7], p[11] - p[8]);
  }
};

/// Positive when the vectors a and b enclose an acute angle, zero when it is right (or one of them is zero).
struct Dot2d {
  static constexpr std::string_view name = "dot2d";
  static constexpr int points = 2, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    return dot2(p[0], p[1], p[2], p[3]);
  }
};

struct Dot3d {
  static constexpr std::string_view name = "dot3d";
  static constexpr int points = 2, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return dot3(p[0], p[1], p[2], p[3], p[4], p[5]);
  }
};

/// Positive when the angle at b, between the directions to a and to c, is acute.
struct Angle2d {
  static constexpr std::string_view name = "angle2d";
  static constexpr int points = 3, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return dot2(p[0] - p[2], p[1] - p[3], p[4] - p[2], p[5] - p[3]);
  }
};

struct Angle3d {
  static constexpr std::string_view name = "angle3d";
  static constexpr int points = 3, dimension = 3;
  template <class T>
  constexpr auto operator()(const std::array<T, 9>& p) const {
    return dot3(p[0] - p[3], p[1] - p[4], p[2] - p[5], p[6] - p[3], p[7] - p[4], p[8] - p[5]);
  }
};

/// Positive when the vector b points to the left of a; zero when they are parallel.
struct Cross2d {
  static constexpr std::string_view name = "cross2d";
  static constexpr int points = 2, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 4>& p) const {
    return det2(p[0], p[1], p[2], p[3]);
  }
};

/// One coordinate of the cross product of two vectors in space, which takes the other two axes of each; they are
/// parallel when all three are zero.
struct CrossX : Cross2d {
  static constexpr std::string_view name = "cross_x", axes = "yz";
};
struct CrossY : Cross2d {
  static constexpr std::string_view name = "cross_y", axes = "zx";
};
struct CrossZ : Cross2d {
  static constexpr std::string_view name = "cross_z", axes = "xy";
};

/// Positive when a, b, c, seen from the far end of an axis, turn counterclockwise; they are collinear when they turn
/// about none of the three axes.
struct OrientX : Orient2d {
  static constexpr std::string_view name = "orient_x", axes = "yz";
};
struct OrientY : Orient2d {
  static constexpr std::string_view name = "orient_y", axes = "zx";
};
struct OrientZ : Orient2d {
  static constexpr std::string_view name = "orient_z", axes = "xy";
};

}  // namespace plumb::predicates
