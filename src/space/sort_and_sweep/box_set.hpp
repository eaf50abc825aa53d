// The boxes of one set or of two, numbered through, and their numbers by axis: the same for doubles and floats, in the
// plane and in space.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

#include "space/pairs/boxes_meet.hpp"

namespace plumb::space {

template <class Box>
inline constexpr bool is_planar = axes_of<Box> == 2;

/// min.x, min.y, (min.z,) max.x, ...: number k + axes_of is the end of axis k.
template <class Box>
auto numbers_of(const Box& b) {
  if constexpr (std::is_same_v<Box, Aabb2>) {
    return std::array{b.min.x, b.min.y, b.max.x, b.max.y};
  } else if constexpr (std::is_same_v<Box, Aabb3>) {
    return std::array{b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z};
  } else if constexpr (std::is_same_v<Box, FloatBox2>) {
    return std::array<double, 4>{b.min[0], b.min[1], b.max[0], b.max[1]};
  } else {
    return std::array<double, 6>{b.min[0], b.min[1], b.min[2], b.max[0], b.max[1], b.max[2]};
  }
}

/// b is empty where there is one set.
template <class Box>
struct BoxSet {
  std::span<const Box> a, b = {};
  bool touching = true;

  [[nodiscard]] std::size_t size() const { return a.size() + b.size(); }
  const Box& operator[](std::size_t i) const { return i < a.size() ? a[i] : b[i - a.size()]; }
};

/// As DecidePair asks.
template <class Box>
bool decide_of_set(const void* set, std::int32_t a, std::int32_t b) {
  const auto& boxes = *static_cast<const BoxSet<Box>*>(set);
  return boxes_meet(boxes[static_cast<std::size_t>(a)], boxes[static_cast<std::size_t>(b)], boxes.touching);
}

}  // namespace plumb::space
