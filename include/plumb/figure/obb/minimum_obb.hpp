// Bounding volume (OBB), rotating calipers: which box holds all points in the least volume, and how small can any be?
// And which rectangle holds them in the least area?
//
// Laws: (1) the box contains all points exactly: its half extents are rounded up around axes that are doubles.
// (2) The rectangle's direction is chosen by exact comparison: no edge of the hull gives a smaller one.  (3) No box of
// right angles around the points has less than the volume that certified_minimum_obb gives, which is proved by outward
// rounding; the box returned is within 1e-12 of that, or `excess` says by how much it may not be.  It is where the
// points are more than two thousandths as thick as long, are not farther from the origin than some thousand times
// their extent, which lies between 2^-900 and 2^1000, and their hull has no more vertices than the search is asked to
// take: thinner ones are limited by axes and centers that are doubles.  (4) No Obb3 along the axes of space is smaller.
// An Aabb3 can be, whose ends are doubles where the center is here: in each of its axes a box along those of space is
// wider by an ulp of its center at most, and by rounding its half extent up, which is much for a needle of some ulps.
// (5) The result depends on the points alone, bit for bit: not on their order, on equal ones or on signs of zeros.
// Points in a plane, on a line or in one place get a flat box.
// No points throw InvalidShape; NaN and infinities throw NonFinite; a box that doubles cannot hold throws
// BeyondDoubles.
// Source: O'Rourke, "Finding minimal enclosing boxes", 1985; RTCD 4.4.3; Freeman and Shapira 1975, Toussaint 1983 for
// the plane.
// Cost: the hull; then about quadratic in its edges, some tens of milliseconds for a thousand vertices.  Never more
// than 65,536 parts of the orientations and 4,096 an edge, a microsecond or some each: that bounds it whatever the exponents
// are, some 0.1 s for ten points.  The plane n log n.  Bounded by n^2 operations for n edges of the hull.
#pragma once

#include <span>

#include "plumb/arith/interval.hpp"
#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/hull/hull3.hpp"

namespace plumb {

struct MinimumObbOptions {
  /// Hulls of more vertices are searched by local steps alone.
  std::size_t most_vertices = 8'192;
  /// After so many parts of the orientations the search ends with what is certain by then; it ends earlier for small
  /// hulls, see above.
  std::size_t most_parts = 4'194'304;
};

Obb3 minimum_obb(std::span<const Point3> points, const MinimumObbOptions& options = {});

/// The same, for points of which the hull is known: `hull` is convex_hull(points), of the default options.
Obb3 minimum_obb(std::span<const Point3> points, const Hull3& hull, const MinimumObbOptions& options = {});

struct CertifiedObb3 {
  Obb3 box;
  /// Of boxes of right angles around the points the least volume is between these, in cubes of side 2^unit; unit is 0
  /// where doubles hold the volume well.
  Interval least_volume;
  int unit;
  /// The box has at most 1 + excess times the least volume; infinite where nothing is known, or that is zero and this
  /// box is thicker by the roundings of its axes.
  double excess;
};

/// What minimum_obb returns, and the proof of how small it is.
CertifiedObb3 certified_minimum_obb(std::span<const Point3> points, const MinimumObbOptions& options = {});
CertifiedObb3 certified_minimum_obb(std::span<const Point3> points, const Hull3& hull,
                                    const MinimumObbOptions& options = {});

/// The rectangle of least area, with an edge of the hull on its first axis; that of the axes of the plane where the
/// roundings of those axes and half extents make it smaller.
Obb2 minimum_obb(std::span<const Point2> points);

}  // namespace plumb
