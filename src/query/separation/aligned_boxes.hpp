// Closest points of two axis-aligned boxes: axis by axis, at numbers that they are given by.
//
// Laws: those of query/separation/separation.hpp: along an axis that parts them the two ends that face each other, else the
// first number that both have.  Nothing of what is not finite, or empty.
// Source: RTCD 4.2, 5.1.3.
// Cost: some 100 to 400 ns with the distance.
#pragma once

#include <optional>

#include "plumb/figure/basic/box.hpp"
#include "query/convex/flat_view.hpp"

namespace plumb::query {

struct FacingPoints {
  Aabb3 a, b;  // the boxes, those of the plane in z = 0
  Point3 on_a, on_b;
};

/// Of other figures nothing.
std::optional<FacingPoints> facing_points(const FigureView& a, const FigureView& b);

}  // namespace plumb::query
