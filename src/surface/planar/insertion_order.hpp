// In which order are points inserted, so that each is near the one before it?  A guess: it decides nothing.
//
// Laws: a permutation of the points, the same for the same points everywhere.  The points are drawn into rounds, each
// some eight times as large as all before it, and stand within a round along a Hilbert curve, of which the squares that
// many points share are halved at medians: so clusters within clusters are as good as points spread evenly.
// Source: Amenta, Choi and Rote 2003 (rounds make any input as good as a random one); Skilling 2004 (the curve).
// Cost: linear where points are spread; n log n comparisons of doubles at most.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"

namespace plumb::surface {

/// How many rounds before the last one thing of a number is drawn into: seven of eight into the last.
int rounds_before_last(std::uint32_t index);

std::vector<std::uint32_t> insertion_order(std::span<const Point2> at);

}  // namespace plumb::surface
