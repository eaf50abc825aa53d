// How is a plane seen?  Along the axis that shows it best, so that it is decided in two dimensions.
//
// Laws: the axis is one along which the plane has an area; which one is a guess, by doubles, and the same for the same
// three points.  Above is the side from which what turns counterclockwise in the two dimensions does so.
// Source: RTCD 12.5.1.
// Cost: a sign or two; a projected point as long as its coordinates.
#pragma once

#include <array>

#include "plumb/figure/basic/mesh.hpp"
#include "surface/solid/numbered_points.hpp"

namespace plumb::surface {

/// Seen from above the points with these numbers turn counterclockwise; they are not on one line.
struct TurnedPlane {
  TriangleMesh::Triangle corners;

  /// Positive above the plane.
  [[nodiscard]] Sign side(const NumberedPoints& points, std::uint32_t p) const;
  /// The signs of the upward normal's coordinates.
  [[nodiscard]] std::array<Sign, 3> normal_signs(const NumberedPoints& points) const;
};

class PlaneView {
 public:
  /// The corners are not on one line.
  PlaneView(const NumberedPoints& points, const TriangleMesh::Triangle& corners);

  [[nodiscard]] const TurnedPlane& plane() const { return plane_; }
  [[nodiscard]] int axis() const { return axis_; }

  [[nodiscard]] ExactPoint2 seen(const ExactPoint3& p) const;
  /// The axis of space that the first and the second axis of what is seen is.
  [[nodiscard]] std::array<std::size_t, 2> seen_axes() const;

 private:
  TurnedPlane plane_;
  int axis_ = 2;
};

}  // namespace plumb::surface
