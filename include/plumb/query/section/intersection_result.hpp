// Intersection: what do two figures have in common?  A set of points with exact corners: what the questions of
// intersection.hpp answer.
//
// Laws: (1) the vertices are exact (certify/exact_point.hpp), no two of them equal, no three on one line.  (2) Those of a
// segment ascend lexicographically.  Those of a polygon turn counterclockwise once around, beginning with the
// lexicographically smallest; in space as seen from the side of coplanar_orientation.  So equal sets are told alike,
// whichever figure is named first.  (3) A ray is told by its origin and one further point of it, a line by two points.
// Source: RTCD 5.3, 5.4.
// Cost: none.
#pragma once

#include <vector>

#include "plumb/certify/exact_point.hpp"

namespace plumb {

enum class IntersectionKind : unsigned char {
  nothing,
  point,
  segment,
  ray,
  line,
  polygon,
  solid,  // with a plane of zero normal, which is all of space; vertices ascend lexicographically
};

struct Intersection2 {
  IntersectionKind kind = IntersectionKind::nothing;
  std::vector<ExactPoint2> vertices;

  [[nodiscard]] bool empty() const { return kind == IntersectionKind::nothing; }
};

struct Intersection3 {
  IntersectionKind kind = IntersectionKind::nothing;
  std::vector<ExactPoint3> vertices;

  [[nodiscard]] bool empty() const { return kind == IntersectionKind::nothing; }
};

/// Of what is in common: -1 for nothing, 0 for a point, up to 3.
constexpr int dimension(IntersectionKind kind) {
  switch (kind) {
    case IntersectionKind::nothing:
      return -1;
    case IntersectionKind::point:
      return 0;
    case IntersectionKind::polygon:
      return 2;
    case IntersectionKind::solid:
      return 3;
    default:
      return 1;
  }
}

/// The nearest doubles of the vertices; throws BeyondDoubles where there are none.
std::vector<Point2> approximate(const Intersection2& a);
std::vector<Point3> approximate(const Intersection3& a);

/// Are the sets the same?  Of lines and rays, whose further points may differ, too.
bool operator==(const Intersection2& a, const Intersection2& b);
bool operator==(const Intersection3& a, const Intersection3& b);

}  // namespace plumb
