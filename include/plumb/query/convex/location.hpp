// Point in convex polygon: is a point in a convex polygon, in logarithmic time?
//
//   const ConvexLocator2 locator(polygon);   // once
//   locator.locate(p);                       // a binary search among doubles and two exact signs
//
// Laws: (1) what locate(polygon, p) says (figure/containment/polygon_location.hpp), for convex polygons of any orientation, with
// repeated vertices and vertices on straight edges; all vertices on one line or at one place are that segment or point,
// all boundary.  (2) Two signs decide: to which side of the longest diagonal, and of one edge, which comparing
// coordinates finds.
// A polygon that is not convex, or of fewer than three vertices, throws InvalidShape, NaN and infinity NonFinite.
// Source: RTCD 5.4.1 (figure 5.28), by x instead of by fans, which takes two signs instead of log n.
// Cost: linear once; log n comparisons and two signs a point.  Bounded by n operations for the making, log n signs a
// point, on integers as long as the exponents' span.
#pragma once

#include <cstddef>
#include <vector>

#include "plumb/figure/basic/polygon.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

class ConvexLocator2 {
 public:
  explicit ConvexLocator2(const Polygon2& polygon);

  [[nodiscard]] Location locate(const Point2& p) const;
  [[nodiscard]] bool contains(const Point2& p) const { return locate(p) != Location::outside; }

  /// The corners alone, counterclockwise from the lexicographically smallest; one or two where there is no inside.
  [[nodiscard]] std::vector<Point2> corners() const;

 private:
  // From the lexicographically smallest corner to the largest, below and above; x ascends, but for a vertical edge at
  // the end of the lower and at the start of the upper chain.
  std::vector<Point2> lower_, upper_;
};

}  // namespace plumb
