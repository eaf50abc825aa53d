// Nearest neighbor: which of many items may be the nearest to a point?  What lanes of doubles tell, for a few items to be
// compared exactly.
//
// Laws: the square of the distance of item i from p is at least lower[i], and that of one item at most what is told; so
// that the nearest are among those whose lower bound is no more.
// Source: query/closest/distance_bounds.hpp.
// Cost: a pass in lanes.
#pragma once

#include <cstddef>
#include <cstdint>

#include "plumb/arith/point.hpp"

namespace plumb::query::batch {

/// The lanes read and write up to so many items beyond the last.
inline constexpr std::size_t most_lanes = 8;

/// Of n items of one, two or three corners, whose coordinates are at `of`, corner by corner.
using Scan = double(const double* const* of, std::size_t n, const Point3& p, double* lower);
Scan scan_points, scan_segments, scan_triangles;

/// Writes the numbers of those whose lower bound is not above `most`; says how many there are.
std::size_t list_up_to(double most, const double* lower, std::size_t n, std::uint32_t* which);

}  // namespace plumb::query::batch
