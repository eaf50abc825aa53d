// From which parts are convex sets put together?  Polygons in space, and the hulls of points in one plane.
#pragma once

#include <span>

#include "query/convex/set.hpp"

namespace plumb::query::meeting {

/// Vertices that turn once around (turn 1: counterclockwise as seen along the axis), in the plane of these points.
ConvexSet<3> polygon_set(std::vector<Point3> vertices, const std::array<Point3, 3>& plane, std::size_t axis, int turn);

/// The hull of points that lie in one plane, on a line or at one place.
ConvexSet<3> flat_set(std::span<const Point3> points);
/// The same of points that no doubles hold; there is one at least.
ConvexSet<3> flat_set(std::vector<Vec<BigDyadic, 3>> corners);

}  // namespace plumb::query::meeting
