// Swept tests in the plane: which figure of space in motion is a figure of the plane under its pose, in z = 0?
//
// Laws: exact; features of the figure in space are given their numbers in the plane.  What is round keeps a pose that is a
// similarity one in space, if lengths are multiplied by a double.
// Source: RTCD 5.5.
// Cost: a copy of the figure.
#pragma once

#include <variant>

#include "plumb/query/time_of_impact/posed.hpp"

namespace plumb::query {

class LiftedMotion {
 public:
  explicit LiftedMotion(const PosedMotion& flat);
  LiftedMotion(const LiftedMotion&) = delete;
  LiftedMotion& operator=(const LiftedMotion&) = delete;

  [[nodiscard]] PosedMotion motion() const;
  [[nodiscard]] Feature in_plane(const Feature& f) const;

 private:
  FigureKind kind_;
  std::variant<Point3, Segment3, Triangle3, Polygon3, HoledPolygon3, Aabb3, Obb3, Sphere3, Capsule3> shape_;
  AnyPose pose_;
  Vector3 by_;
};

}  // namespace plumb::query
