// Minimum bounding box: how large is the box of exactly right angles that has these axes?
//
// The axes are two of pairs of doubles, which are perpendicular, and their product: not rounded, as those of a box of
// doubles are.
// Laws: the answer is no less than the volume, in cubes of side 2^exponent (figure/obb/flush_arcs.hpp), and larger by
// some 2^-90 of the extent in each width; infinite where the axes are dependent.
// Source: Gram and Schmidt.
// Cost: a pass over the vertices in doubles that carry their errors, pairs of doubles for the few farthest.
#pragma once

#include <array>

#include "figure/obb/flush_arcs.hpp"

namespace plumb::figure::frame {

struct RightAngle {
  arith::Vec<Ball> first, second;
};

/// The first axis, and what is left of the second beside it.
RightAngle right_angle(const std::array<Vector3, 3>& axes);

double volume_above(const FlushArcs& flush, const RightAngle& axes);

}  // namespace plumb::figure::frame
