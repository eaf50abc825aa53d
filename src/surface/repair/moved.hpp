// How far does a point move, and is a triangle turned over when its corners do?
//
// Laws: the distance is the nearest double.  The sign is that of the exact dot product of the normals before and after:
// negative where the triangle is turned over, zero where one of them has no area or they are at right angles.
// Source: RTCD 12.1.
// Cost: pairs of doubles; integers where these leave a doubt.
#pragma once

#include <array>

#include "figure/basic/signed_sums.hpp"
#include "plumb/arith/point.hpp"

namespace plumb::surface {

inline double how_far(const Point3& from, const Point3& to) {
  if (from == to) return 0;
  return arith::exact_sum::nearest_root([&](const auto& number) {
    using namespace figure::signed_sums;
    const auto way = vector(number, to) - vector(number, from);
    return dot(way, way);
  });
}

inline Sign keeps_facing(const std::array<Point3, 3>& before, const std::array<Point3, 3>& after) {
  return arith::exact_sum::sign([&](const auto& number) {
    using namespace figure::signed_sums;
    const auto normal = [&](const std::array<Point3, 3>& t) {
      const auto origin = vector(number, t[0]);
      return cross(vector(number, t[1]) - origin, vector(number, t[2]) - origin);
    };
    return dot(normal(before), normal(after));
  });
}

}  // namespace plumb::surface
