// How is a convex body drawn?  By the corners of a hull, and its edges.
//
// Law: edges are pairs of numbers of points, each once; a hull that is a segment is one edge, one that is a point has none.
// Source: none.
// Cost: that of the hull.
#pragma once

#include <array>
#include <set>
#include <span>
#include <vector>

#include "plumb/figure/hull/hull3.hpp"

namespace plumb::tool {

struct DrawnHull {
  std::vector<Point3> points;
  std::set<std::array<std::size_t, 2>> edges;
};

/// Takes a hull of these points.
DrawnHull drawn_hull(const Hull3& hull, std::span<const Point3> of);

}  // namespace plumb::tool
