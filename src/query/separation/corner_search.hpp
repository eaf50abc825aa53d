// GJK: between which corners of two hulls is the least way?  A guess in doubles.
//
// Law: nothing is certain of it; four corners say that the hulls are likely to meet.
// Source: Gilbert, Johnson and Keerthi 1988; RTCD 9.5.
// src/query/gjk/corner_search.cpp finds them, for the support mappings are there.
// Cost: some 100 to 600 ns; of polyhedra the way climbed, of 200 vertices some 1,300 ns.
#pragma once

#include "query/separation/nearest_corners.hpp"

namespace plumb::query {

/// From these corners on, or none; `rounds` grows by the simplices looked at.
DifferenceCorners guessed_nearest(const CoreCorners& a, const CoreCorners& b, const DifferenceCorners& known,
                                  std::uint32_t& rounds);
DifferenceCorners guessed_nearest(const CoreCorners& a, const CoreCorners& b);

}  // namespace plumb::query
