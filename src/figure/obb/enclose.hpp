// Bounding volume (OBB): how far must a box with these axes and this center reach, to contain points or other boxes for
// certain?
//
// Laws: half extents are the least that contain everything, rounded up; the axes are independent.
// Source: Cramer's rule.
// Cost: two passes over the points in doubles and pairs of doubles for the farthest few; a box some 2 us.
#pragma once

#include <span>

#include "figure/basic/pose_numbers.hpp"
#include "plumb/figure/basic/box.hpp"

namespace plumb::figure::enclosing {

/// Do the axes span space, exactly?
bool independent(const std::array<Vector3, 3>& axes);

/// The least half extents; infinite where doubles do not suffice.
Vector3 half(const std::array<Vector3, 3>& axes, const Point3& center, std::span<const Point3> points);

/// The image of a box under a pose, none for the identity.
struct Body {
  const Obb3& box;
  const CertainPose* pose = nullptr;
};
Vector3 half(const std::array<Vector3, 3>& axes, const Point3& center, std::span<const Body> bodies);

/// A center for the points that makes half extents small; by doubles.
Point3 center(const std::array<Vector3, 3>& axes, std::span<const Point3> points);

/// Makes a box around the image of the box.
Obb3 transformed(const Obb3& box, const CertainPose& pose);

}  // namespace plumb::figure::enclosing
