// Which points are one and the same?  What exact welding, and reading a file that repeats its corners, begin with.
//
// Law: equality is that of the coordinates, so -0 equals +0; the same points in the same order give the same numbers.
// Source: RTCD 12.1.
// Cost: linear, some 50 ns a point, but for sorting points that share a bucket.  Bounded by n log n operations.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"

namespace plumb {

/// For each point the smallest number of a point equal to it, its own where there is none.
std::vector<std::uint32_t> first_equal(std::span<const Point3> points);

}  // namespace plumb
