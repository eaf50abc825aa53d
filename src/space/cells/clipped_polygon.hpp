// Polygon clipping (Sutherland and Hodgman), exactly: what of a convex polygon is on one side of planes?
//
// A corner that is made is where an edge as given meets a plane, or where the polygon's plane and two others meet:
// planes through points as given, however often it is cut.
// Laws: closed: what is on the plane stays; what is left may be a segment, whose ends may be named twice, or a point.
// Source: Sutherland and Hodgman 1974; docs/implicit_points.md.
// Cost: a sign a corner, one corner made for each edge that is cut.
#pragma once

#include <vector>

#include "plumb/certify/exact_point.hpp"
#include "plumb/figure/basic/polygon.hpp"
#include "space/cells/three_points.hpp"

namespace plumb::space {

class ClippedPolygon {
 public:
  explicit ClippedPolygon(const Polygon3& polygon);

  /// Keeps what is where side(plane, .) is not negative.
  void keep(const ThreePoints& plane);
  [[nodiscard]] bool empty() const { return corners_.empty(); }
  /// No two of them equal.
  [[nodiscard]] std::vector<ExactPoint3> corners() const;

 private:
  /// What an edge lies in: the line of two points as given, or a plane that cut it.
  struct Edge {
    bool is_given;
    Point3 a, b;
    ThreePoints plane;
  };
  struct Corner {
    ExactPoint3 at;
    Edge edge;  // to the next
  };
  [[nodiscard]] ExactPoint3 crossing(const Edge& edge, const ThreePoints& plane) const;

  ThreePoints plane_;
  std::vector<Corner> corners_;
};

}  // namespace plumb::space
