// Boxes for contacts: turned by angles whose cosines are rounded.
#pragma once

#include <cmath>

#include "plumb/figure/basic/box.hpp"

namespace plumb {

/// A box turned by some angles, whose axes are those of rounded cosines.
inline Obb3 turned_box(const Point3& center, double yaw, double pitch, const Vector3& half) {
  const double c = std::cos(yaw), s = std::sin(yaw), d = std::cos(pitch), t = std::sin(pitch);
  return {center, {Vector3{c, 0, -s}, Vector3{s * t, d, c * t}, Vector3{s * d, -t, c * d}}, half};
}

}  // namespace plumb
