// Which box stands for a box where only the order of numbers counts: whole numbers, by a map that keeps their order.
//
// Laws: a map is monotone on each axis, so of two numbers whose ordinals differ the one with the smaller ordinal is
// the smaller; where ordinals are equal, the numbers themselves decide.  Nothing else is asked of a map: it may round
// as it likes.
#pragma once

#include <array>
#include <cstdint>

namespace plumb::space {

/// Axis 0 is the one along which boxes are swept.
struct OrdinalBox {
  std::array<std::int32_t, 3> low, high;
  std::int32_t number;
  std::int32_t marks;  // boxes that have a mark in common are no pair here
};
static_assert(sizeof(OrdinalBox) == 32);

/// Ordinals lie below 2^30.
inline constexpr int ordinal_bits = 30;
inline constexpr std::int32_t beyond_ordinals = 0x7fffffff;

/// Marks of boxes of the first and of the second of two sets.
inline constexpr std::int32_t of_first_set = 1 << 8, of_second_set = 1 << 9;

}  // namespace plumb::space
