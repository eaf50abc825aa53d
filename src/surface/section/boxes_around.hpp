// Which boxes lie in which?
//
// Laws: exact, closed: equal boxes lie in each other.
// Source: RTCD 7.5 (sort and sweep), with a segment tree (Bentley 1977) over the heights that are asked about.
// Cost: n log n, and the pairs whose boxes have the lower left corner of one in common.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/box.hpp"

namespace plumb::surface {

/// For each box the others in which it lies, in ascending order.
std::vector<std::vector<std::uint32_t>> boxes_around(std::span<const Aabb2> boxes);

}  // namespace plumb::surface
