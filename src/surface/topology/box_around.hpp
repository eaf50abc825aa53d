// Which box holds all that is within a length of a segment?
//
// Law: the box holds it, and may be larger by the next double.  Where the length is 0, it is the segment's own.
// Cost: six sums.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "plumb/figure/basic/box.hpp"

namespace plumb::surface {

inline Aabb3 box_around(const Point3& a, const Point3& b, double length) {
  constexpr double greatest = std::numeric_limits<double>::max();
  const auto below = [&](double x, double y) {
    const double least = std::min(x, y);
    return length == 0 ? least : std::max(-greatest, std::nextafter(least - length, -greatest));
  };
  const auto above = [&](double x, double y) {
    const double most = std::max(x, y);
    return length == 0 ? most : std::min(greatest, std::nextafter(most + length, greatest));
  };
  return {{below(a.x, b.x), below(a.y, b.y), below(a.z, b.z)}, {above(a.x, b.x), above(a.y, b.y), above(a.z, b.z)}};
}

}  // namespace plumb::surface
