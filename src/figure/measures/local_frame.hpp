// Where are points in a frame of their own?  In plain doubles: for guesses only.
//
// Laws: local coordinates are about the middle of the points' box, scaled by a power of two to the order of 1, so that
// neither the largest nor the smallest doubles hurt; axes are orthonormal up to rounding, by descending spread.
// Source: RTCD 4.3.3, 4.4.3.
// Cost: two passes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"

namespace plumb::figure {

struct LocalFrame {
  Point3 middle;
  int exponent;  // of the scale: local = (p - middle) 2^-exponent
  std::array<Vector3, 3> axes;

  /// Along the axes.
  [[nodiscard]] Vector3 local(const Point3& p) const;
  /// The point of these local coordinates, about; and the vector.
  [[nodiscard]] Point3 world(const Vector3& along_axes) const;
  [[nodiscard]] Vector3 world_vector(const Vector3& along_axes) const;
};

/// Of at least one point.
LocalFrame principal_frame(std::span<const Point3> points);

}  // namespace plumb::figure
