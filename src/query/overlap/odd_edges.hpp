// Which parts of edges do an odd number of them cover?
//
// Of edges that cover one another an even number of times nothing is beside but what is on both sides: they are
// boundary, and near to the inside only as other points are.
// Source: RTCD 5.4.1.
// Cost: quadratic where edges lie on one another.
#pragma once

#include <span>
#include <vector>

#include "plumb/figure/basic/linear.hpp"

namespace plumb::query {

/// As segments between corners.
std::vector<Segment3> odd_edges(std::span<const Segment3> edges);

}  // namespace plumb::query
