// Which boxes of a tree does the ray along x from a point meet?
//
// Law: those that it meets, and by rounding a few beside them.
// Source: RTCD 5.4.3.
// Cost: five comparisons a box.
#pragma once

#include <array>

#include "plumb/space/bvh/box_tree.hpp"

namespace plumb::space {

/// The point is rounded both ways, as boxes are.
struct AlongX {
  std::array<float, 3> below, above;

  AlongX(const BoxFrame& frame, const Point3& p) : AlongX(frame, p, p) {}
  /// From a point that is known to be in the box between two.
  AlongX(const BoxFrame& frame, const Point3& min, const Point3& max)
      : below{frame.below(min.x), frame.below(min.y), frame.below(min.z)},
        above{frame.above(max.x), frame.above(max.y), frame.above(max.z)} {}
  bool operator()(const BoxNode& node) const {
    return below[0] <= node.max[0] && node.min[1] <= above[1] && below[1] <= node.max[1] && node.min[2] <= above[2] &&
           below[2] <= node.max[2];
  }
};

}  // namespace plumb::space
