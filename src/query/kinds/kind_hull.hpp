// Is this the hull of these points?  Foreign triangles, judged by exact signs.
//
// Laws: right are no triangles for points of one plane, and otherwise triangles that close edge by edge, each of them
// with area and no point outside of it, that enclose the hull's volume once.  Then every extreme point is a corner: a
// closed surface all of whose triangles lie in the hull's faces, facing outward, covers these a whole number of times.
// Of equal points any may be named.
// Source: RTCD 3.9.
// Cost: n signs a triangle, and a hull.
#pragma once

#include "plumb/degenerate/kind.hpp"

namespace plumb::degenerate {

Answer call_hull(ForeignFunction function, std::span<const Passed> passed);
Answer exact_hull(std::span<const double> numbers);
Judgment judge_hull(std::span<const double> numbers, const Answer& given);

using HullFunction = std::size_t (*)(const double* points, std::size_t n, std::size_t* triangles, std::size_t capacity);

}  // namespace plumb::degenerate
