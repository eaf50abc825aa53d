// How often does a triangle come before the line that goes from beside a facet along x?  What sums to winding numbers.
//
// Laws: exact.  The line goes from the middle of the facet, which is moved by infinitesimals: upward along z by one,
// forward along y by a smaller one, so that it passes no edge; where both leave it in the facet's plane, it starts above.
// A triangle that holds the middle has to hold the facet.
// Source: RTCD 5.4.3; Edelsbrunner and Muecke 1990.
// Cost: some exact signs for each triangle.
#pragma once

#include "plumb/figure/basic/box.hpp"
#include "surface/solid/plane_view.hpp"

namespace plumb::surface {

class LineFromFacet {
 public:
  /// The plane is that of the corners.
  LineFromFacet(const NumberedPoints& points, const TriangleMesh::Triangle& corners, const TurnedPlane& plane);

  /// Or below the facet.
  [[nodiscard]] bool starts_above() const { return moved_ == Sign::positive; }
  /// Holds the line.
  [[nodiscard]] Aabb3 box() const;
  /// What a triangle adds to the winding number of what the line starts in: 1, 0 or -1.
  [[nodiscard]] int winding_of(const std::array<Point3, 3>& triangle) const;
  [[nodiscard]] int winding_of(const NumberedPoints& points, const TriangleMesh::Triangle& corners) const;

 private:
  template <class Point>
  [[nodiscard]] int winding_where_passed(Sign turn, const std::array<Point, 3>& triangle) const;

  ExactPoint3 from_;
  ExactPoint2 seen_;
  Sign normal_x_, moved_;
};

}  // namespace plumb::surface
