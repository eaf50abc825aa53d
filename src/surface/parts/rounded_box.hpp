// Between which doubles do exact points lie?
//
// Law: rounding to nearest is monotone: a set that lies in another has its box in the other's.
// Source: RTCD 4.2.
// Cost: three comparisons a point.
#pragma once

#include <array>

#include "plumb/certify/exact_point.hpp"

namespace plumb::surface {

struct RoundedBox {
  std::array<double, 3> low{}, high{};
  bool empty = true;

  void add(const ExactPoint3& point) {
    const Point3 p = approximate(point);
    const std::array<double, 3> at{p.x, p.y, p.z};
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = empty || at[i] < low[i] ? at[i] : low[i];
      high[i] = empty || high[i] < at[i] ? at[i] : high[i];
    }
    empty = false;
  }
  [[nodiscard]] bool holds(const RoundedBox& other) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (other.low[i] < low[i] || high[i] < other.high[i]) return false;
    return true;
  }
};

}  // namespace plumb::surface
