// What do lanes of doubles say of one ray against many axis-aligned boxes?
//
// The tests are those of ray_hits.cpp, term by term.
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
