// Closest points of two hulls: between which corners of theirs is the least way, for certain?
//
// Laws: what is NaN or infinite has no answer.  The corners are independent and their nearest point needs all of them; `meets`: it is the origin.  Signs are those
// of doubles with running bounds, then of integers of a thousand bits; where these do not hold the numbers there is no
// answer.  `is_alone`: there is no other nearest pair.
// Source: query/separation/nearest_corners.hpp.
// Cost: below a microsecond, where planes are parallel or touch some microseconds; no allocation.
#pragma once

#include <vector>

#include "query/separation/nearest_corners.hpp"

namespace plumb::query {

struct ProvedCorners {
  DifferenceCorners corners;
  bool meets = false, is_alone = false;
  Support a, b;  // where they do not meet
};

std::optional<ProvedCorners> proved_nearest(const CoreCorners& a, const CoreCorners& b);
/// From a guess, which may be of any corners.
std::optional<ProvedCorners> proved_nearest(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& guess);
/// Of any finite numbers, from a guess: exact from the first turn on, whose corners it appends; microseconds a turn.
ProvedCorners certainly_nearest(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& guess,
                                std::vector<DifferenceCorners>* seen = nullptr);

/// Of corners that are proved: the sign of how far the hulls are apart, less two radii.
Sign gap_of(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& corners, double radius_a,
            double radius_b);

/// The different ones among the corners of a (0) or b (1).
struct NamedCorners {
  std::array<std::uint32_t, 4> index{};
  std::size_t size = 0;
  [[nodiscard]] std::span<const std::uint32_t> all() const { return {index.data(), size}; }
};
NamedCorners named(const DifferenceCorners& corners, std::size_t which);

}  // namespace plumb::query
