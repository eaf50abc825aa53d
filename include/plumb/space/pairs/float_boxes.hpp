// float32 boxes of the broad phase: which boxes of doubles are they?
//
// Laws: a float stands for exactly the real number that it is, so a widened box is the same set of points.
// Source: RTCD 2.4.1.
// Cost: a conversion a number.  Nothing is searched.
#pragma once

#include <array>
#include <type_traits>

#include "plumb/space/bvh/box_frame.hpp"

namespace plumb {

/// In the plane, as FloatBox3 is in space; empty where min > max.
struct FloatBox2 {
  std::array<float, 2> min, max;
  friend bool operator==(const FloatBox2&, const FloatBox2&) = default;
};

constexpr Aabb2 widened(const FloatBox2& b) { return {{b.min[0], b.min[1]}, {b.max[0], b.max[1]}}; }
constexpr Aabb3 widened(const FloatBox3& b) { return {{b.min[0], b.min[1], b.min[2]}, {b.max[0], b.max[1], b.max[2]}}; }

namespace space {

/// 2 in the plane, 3 in space.
template <class Box>
inline constexpr std::size_t axes_of =
    std::is_same_v<Box, Aabb2> || std::is_same_v<Box, FloatBox2> ? std::size_t{2} : std::size_t{3};

}  // namespace space

}  // namespace plumb
