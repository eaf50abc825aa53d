// Which of two planes does a ray meet first, and is that before or after a given parameter?
//
// A line o + t d meets the plane of a, b, c, whose normal is n = (b - a) x (c - a), at t = N / D with N = n . (a - o)
// and D = n . d.  Two such quotients are compared crosswise; the signs of the denominators are those of
// orient_seen_from.
// Laws: swapping the two triangles flips the sign; so does swapping two points of one triangle, whose N and D both
// change sign; a plane parallel to the line makes D zero.
// Source: RTCD 5.3.1, 5.3.6.  Degree 6; against a parameter the terms differ in degree.
#pragma once

#include <array>
#include <string_view>

#include "plumb/predicates/cross.hpp"

namespace plumb::predicates {

template <class T, class U>
struct Parameter {
  T numerator;
  U denominator;
};
template <class T, class U>
Parameter(T, U) -> Parameter<T, U>;

/// Where the line from argument 0 with this direction meets the plane of arguments first, first + 1, first + 2.
template <class T, std::size_t N, class U>
constexpr auto ray_parameter(const std::array<T, N>& p, const Triple<U>& direction, std::size_t first) {
  const auto normal = cross(difference(p, first, first + 1), difference(p, first, first + 2));
  return Parameter{dot(difference(p, 0, first), normal), dot(direction, normal)};
}

/// N1 D2 - N2 D1.
template <class T, std::size_t N, class U>
constexpr auto parameter_order(const std::array<T, N>& p, const Triple<U>& direction) {
  const auto one = ray_parameter(p, direction, 2), other = ray_parameter(p, direction, 5);
  return one.numerator * other.denominator - other.numerator * one.denominator;
}

/// (origin, direction, a, b, c, d, e, f): N1 D2 - N2 D1 of the planes of a, b, c and d, e, f.
struct RayOrder {
  static constexpr std::string_view name = "ray_order";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 3, 3, 3};
  template <class T>
  constexpr auto operator()(const std::array<T, 24>& p) const {
    return parameter_order(p, argument(p, 1));
  }
};

/// (p, q, a, b, c, d, e, f): the same for the direction q - p, which is not rounded.
struct SegmentOrder {
  static constexpr std::string_view name = "segment_order";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 3, 3, 3};
  template <class T>
  constexpr auto operator()(const std::array<T, 24>& p) const {
    return parameter_order(p, difference(p, 0, 1));
  }
};

/// (origin, direction, a, b, c, t): N - t D = n . (a - o - t d), positive when the point at t lies below the plane.
struct RayAgainst {
  static constexpr std::string_view name = "ray_against";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 1};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 16>& p) const {
    return triple(difference(p, 0, 2) - scaled(argument(p, 1), p[15]), difference(p, 2, 3), difference(p, 2, 4));
  }
};

/// (p, q, a, b, c, t): the same for the direction q - p, which is not rounded.
struct SegmentAgainst {
  static constexpr std::string_view name = "segment_against";
  static constexpr std::array arguments{3, 3, 3, 3, 3, 1};
  static constexpr bool homogeneous = false;
  template <class T>
  constexpr auto operator()(const std::array<T, 16>& p) const {
    return triple(difference(p, 0, 2) - scaled(difference(p, 0, 1), p[15]), difference(p, 2, 3), difference(p, 2, 4));
  }
};

}  // namespace plumb::predicates
