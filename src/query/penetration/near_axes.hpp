// Of axes of two boxes that may be nearest: which one is, and what leads where along it?  Four at once, by pairs of doubles in lanes.
//
// Laws: what is told is exact; a sign that is left open is zero, and a sign of zero is left open.  Nothing is told on
// processors without lanes of four.
// Source: query/penetration/box_axes.hpp; RTCD 13.7.
// Cost: some 900 operations for each four axes; no allocation.
#pragma once

#include <span>

#include "query/penetration/box_axes.hpp"

namespace plumb::query::parting {

struct NearAxisSigns {
  std::uint32_t least = 0;  // a guess, of those that were asked about: which one overlaps least over its length
  Sign overlap = Sign::zero, middle = Sign::zero;  // along that one, as NearAxes has them
  std::array<Sign, 6> along{};
  std::array<Sign, 16> order{};  // of each; positive: farther than that one
};

/// Sixteen at most, one at least.
NearAxisSigns near_axis_signs(const GivenBox& a, const GivenBox& b, std::span<const NearAxes::Pair> pairs);
NearAxisSigns near_axis_signs(const PosedBox& a, const PosedBox& b, std::span<const NearAxes::Pair> pairs);

}  // namespace plumb::query::parting
