// Do figures meet that a pose moves alike?  By the signs of their posed points, of which no coordinate is ever rounded.
//
// Laws: (1) figures are closed sets, and the degenerate ones what their points say; (2) the answer is that of the exact
// images of all points under the pose, whatever its matrix, if its determinant is not zero.
// Source: RTCD 5.2.10, 5.4.1, by orientations alone.
// Cost: microseconds a sign where points are in special position; tens of signs.
#pragma once

#include <span>

#include "plumb/arith/pose.hpp"
#include "plumb/figure/basic/linear.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::tool::stability {

bool posed_meet(const Segment3& s, const Triangle3& t, const Pose& pose);
bool posed_meet(const Triangle3& a, const Triangle3& b, const Pose& pose);

/// In the closed polygon: on its chain, or an odd number of edges is crossed by a ray that is posed as well.
bool posed_in_polygon(std::span<const Point2> polygon, const Point2& p, const Pose2& pose);

}  // namespace plumb::tool::stability
