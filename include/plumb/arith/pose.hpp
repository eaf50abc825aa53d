// Where is a moved shape?  A matrix and a translation given in doubles, and a shape under them, not rounded.
//
// Laws: a pose is what its numbers say: the point matrix * p + translation, exactly, whatever the matrix (a rotation in
// doubles is never quite orthonormal; a mirror or a projection will do as well).  A posed shape is the exact image.
// Source: RTCD 3.2.
// Cost: none.
#pragma once

#include <array>

#include "plumb/arith/point.hpp"

namespace plumb {

struct Pose2 {
  std::array<Vector2, 2> columns;
  Vector2 translation;
  friend bool operator==(const Pose2&, const Pose2&) = default;
};

struct Pose {
  std::array<Vector3, 3> columns;
  Vector3 translation;
  friend bool operator==(const Pose&, const Pose&) = default;
};

/// Where everything stays.
inline constexpr Pose identity_pose{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {0, 0, 0}};

/// The image of the shape under the pose.
template <class Shape, class By = Pose>
struct Posed {
  Shape shape;
  By pose;
  friend bool operator==(const Posed&, const Posed&) = default;
};
template <class Shape, class By>
Posed(Shape, By) -> Posed<Shape, By>;

}  // namespace plumb
