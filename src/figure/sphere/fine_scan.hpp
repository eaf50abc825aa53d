// Extreme points: who of many is not certainly inside a ball that is known to some hundred bits?  What is left to exact
// signs of points that lie on its boundary up to ulps.
//
// Laws: whoever is not named is strictly inside.  Machines without fused multiply-adds in four lanes name everyone.
// Source: plumb/arith/ball.hpp.
// Cost: some 10 ns a point.
#pragma once

#include <span>
#include <vector>

#include "figure/sphere/spanned_ball.hpp"

namespace plumb::figure::sphere {

/// Appends first + i for points[i].
void not_certainly_inside(const FineBall<SpannedCircle2>& ball, std::span<const Point2> points, std::size_t first,
                          std::vector<std::size_t>& into);
void not_certainly_inside(const FineBall<SpannedSphere3>& ball, std::span<const Point3> points, std::size_t first,
                          std::vector<std::size_t>& into);

}  // namespace plumb::figure::sphere
