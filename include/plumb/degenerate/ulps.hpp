// Which double is k steps further, and how many bits does a double use?
//
// Laws: (1) steps count the doubles between, with 0.0 and -0.0 as one; (2) a move never leaves the finite doubles: it
// stops at the largest; (3) x == m * 2^lowest_exponent(x) with m odd and below 2^mantissa_length(x), for x != 0.
// Source: the order of the bit patterns of IEEE-754 doubles (RTCD 11.2.1).
// Cost: a few instructions.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "plumb/predicates/standard.hpp"

namespace plumb {

/// Place of a finite double among the doubles in ascending order; both zeros have place 0.
constexpr std::int64_t place_of(double x) {
  const auto bits = std::bit_cast<std::int64_t>(x);
  return bits >= 0 ? bits : std::numeric_limits<std::int64_t>::min() - bits;
}

/// The double at a place; 0.0 for place 0.
constexpr double double_at(std::int64_t place) {
  return std::bit_cast<double>(place >= 0 ? place : std::numeric_limits<std::int64_t>::min() - place);
}

/// The double `steps` further up (or down), at most the largest finite one in that direction.
constexpr double moved_by_ulps(double x, std::int64_t steps) {
  constexpr std::int64_t last = std::bit_cast<std::int64_t>(std::numeric_limits<double>::max());
  const std::int64_t place = place_of(x);
  if (steps > last - std::max<std::int64_t>(place, 0)) return std::numeric_limits<double>::max();
  if (steps < -last - std::min<std::int64_t>(place, 0)) return -std::numeric_limits<double>::max();
  return double_at(std::clamp(place + steps, -last, last));
}

/// Exponent of the lowest set bit of a finite x != 0; for zero, 1024, which no finite double reaches.
constexpr int lowest_exponent(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto biased = static_cast<int>((bits >> 52) & 0x7ff);
  std::uint64_t mantissa = bits & ((1ull << 52) - 1);
  if (biased != 0) mantissa |= 1ull << 52;
  return mantissa == 0 ? 1024 : std::max(biased, 1) - 1075 + std::countr_zero(mantissa);
}

/// Exponent of the leading bit of a finite x != 0; for zero, -1075, which no double reaches.
constexpr int highest_exponent(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto biased = static_cast<int>((bits >> 52) & 0x7ff);
  return biased != 0 ? biased - 1023 : static_cast<int>(std::bit_width(bits & ((1ull << 52) - 1))) - 1075;
}

/// Bits from the leading to the lowest set one: 1 for a power of two, 53 at most, 0 for zero.
constexpr int mantissa_length(double x) { return x == 0 ? 0 : highest_exponent(x) - lowest_exponent(x) + 1; }

}  // namespace plumb
