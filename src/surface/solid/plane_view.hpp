// How is a plane seen?  Along the axis that shows it best, so that it is decided in two dimensions.
//
// Laws: the axis is one along which the plane has an area; which one is a guess, by doubles, and the same for the same
// three points.  Above is the side from which what turns counterclockwise in the two dimensions does so.
// Source: RTCD 12.5.1.
// Cost: a sign or two; a projected point as long as its coordinates.
#pragma once

#include <array>

#include "plumb/certify/exact_point.hpp"

namespace plumb::surface {

/// Seen from above the points turn counterclockwise; they are not on one line.
struct TurnedPlane {
  std::array<Point3, 3> points;

  /// Positive above the plane.
  [[nodiscard]] Sign side(const ExactPoint3& p) const;
  [[nodiscard]] Sign side(const Point3& p) const;
  /// The signs of the upward normal's coordinates.
  [[nodiscard]] std::array<Sign, 3> normal_signs() const;
};

class PlaneView {
 public:
  /// The points are not on one line.
  explicit PlaneView(const std::array<Point3, 3>& points);

  [[nodiscard]] const TurnedPlane& plane() const { return plane_; }

  [[nodiscard]] ExactPoint2 seen(const ExactPoint3& p) const;
  /// The axis of space that the first and the second axis of what is seen is.
  [[nodiscard]] std::array<std::size_t, 2> seen_axes() const;

 private:
  TurnedPlane plane_;
  int axis_ = 2;
};

/// The point's shadow along the axis: (x, y), (y, z) or (z, x).
Point2 shadow(const Point3& p, int axis);
ExactPoint2 shadow(const ExactPoint3& p, int axis);

/// Three axes, first the one along which doubles tell the largest area.
std::array<int, 3> guessed_axes(const std::array<Point3, 3>& points);

}  // namespace plumb::surface
