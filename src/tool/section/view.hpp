// How is a section shown on paper?  Coordinates of its plane, as seen from the normal's side, z upward where it can be.
//
// u runs along the plane's horizontal, v up its slope, both in the mesh's unit and from the point of the plane that is
// over the origin in their directions; of a horizontal plane u is x and v is y, or -y seen from below.
// Laws: each coordinate is rounded once, from the exact corner.
// Source: none.
// Cost: none for planes of one coordinate, else some 20 us a corner.
#pragma once

#include <array>

#include "plumb/arith/rational.hpp"
#include "plumb/surface/section/section.hpp"

namespace plumb::tool {

class SectionView {
 public:
  explicit SectionView(const AnyPlane3& plane);

  [[nodiscard]] Point2 at(const TriangleMesh& mesh, const SectionCorner& corner) const;

 private:
  /// Along a vector, divided by its length.
  struct Axis {
    std::array<Rational, 3> along;
    Rational squared_length;
    int only = -1;  // the one coordinate that counts, if there is one
  };
  explicit SectionView(const AnyPlane3& plane, const std::array<Rational, 3>& normal);

  AnyPlane3 plane_;
  std::array<Axis, 2> axes_;
};

/// The area of a closed contour, positive for outer ones, and the length of its line; of the rounded corners.
struct ContourMeasures {
  double area = 0, length = 0;
};
ContourMeasures measures(const std::vector<Point2>& corners, bool closed);

}  // namespace plumb::tool
