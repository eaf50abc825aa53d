// Bounding volume (OBB), rotating calipers: which box holds all points in the least volume?  And which rectangle in the
// least area?
//
// Laws: (1) the box contains all points exactly: its half extents are rounded up around axes that are doubles.
// (2) The rectangle's direction is chosen by exact comparison: no edge of the hull gives a smaller one.  (3) The box
// has the least volume of all, up to the roundings of its axes and of the search, which compares volumes in doubles;
// where the hull has more vertices than the search is asked to take, it is the best that local steps find.  (4) The
// result depends on the points alone.  Points in a plane, on a line or in one place get a flat box; equal points do not
// matter.
// No points throw InvalidShape; NaN and infinities throw NonFinite; a box that doubles cannot hold throws
// BeyondDoubles.
// Source: O'Rourke, "Finding minimal enclosing boxes", 1985; RTCD 4.4.3; Freeman and Shapira 1975, Toussaint 1983 for
// the plane.
// Cost: the hull; then about quadratic in its edges, some tens of milliseconds for a thousand vertices; the plane n log
// n.
#pragma once

#include <span>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/hull/hull3.hpp"

namespace plumb {

struct MinimumObbOptions {
  /// Hulls of more vertices are searched by local steps alone.
  std::size_t most_vertices = 8'192;
  Execution execution = Execution::serial;  // of the hull
};

Obb3 minimum_obb(std::span<const Point3> points, const MinimumObbOptions& options = {});

/// The same, for points of which the hull is known: `hull` is convex_hull(points).
Obb3 minimum_obb(std::span<const Point3> points, const Hull3& hull, const MinimumObbOptions& options = {});

/// The rectangle of least area; with an edge of the hull on its first axis.
Obb2 minimum_obb(std::span<const Point2> points);

}  // namespace plumb
