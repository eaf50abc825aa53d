// Slab test: what do lanes of doubles say of one ray against many axis-aligned boxes?
//
// The box is apart along an axis of its own where numbers as given say so, and along one across the direction and an
// axis of the box where the corner of its rectangle at which u y - v x is least, or most, is on that side of the line
// (query/ray/box_passed.hpp).  Where none of these is apart they meet.
#pragma once

#include <cstddef>
#include <cstdint>

namespace plumb::query {

/// Along a direction that is not zero; a segment with its rounded direction, and its ends sorted in each axis.
struct BoxBatchRay {
  double origin[3], direction[3], low[3], high[3];
  bool begins, ends;
};

/// Of n boxes, whose numbers are at[0][i] to at[5][i]: 0 no, 1 yes, 2 nothing is told.
void ask_box_lanes(const BoxBatchRay& ray, const double* const* at, std::size_t n, std::uint8_t* told);

}  // namespace plumb::query
