// Which box holds all that is as near to a box as a length?  Rounded outward, within the doubles.
//
// Source: none.
// Cost: six additions.  Nothing is searched.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "plumb/figure/basic/box.hpp"

namespace plumb::world {

inline Aabb3 grown(const Aabb3& b, double by) {
  constexpr double most = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  const auto low = [&](double x) { return std::max(std::nextafter(x - by, -infinity), -most); };
  const auto high = [&](double x) { return std::min(std::nextafter(x + by, infinity), most); };
  return {{low(b.min.x), low(b.min.y), low(b.min.z)}, {high(b.max.x), high(b.max.y), high(b.max.z)}};
}

}  // namespace plumb::world
