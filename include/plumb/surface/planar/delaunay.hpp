// Which triangles join points of the plane, so that the circle of each holds no other point?
//
//   const PlanarTriangulation all = delaunay(points);
//   const PlanarTriangulation with_edges = delaunay(points, segments);   // each segment is an edge, or several
//
// Laws: (1) triangles turn counterclockwise, have area, overlap nowhere and cover the convex hull; every point is a
// corner.  (2) No point lies inside a triangle's circle that is seen from the triangle, where segments hide what is
// behind them.  Where four points lie on one circle, the diagonal between them is that of the lowest index: so the set
// of triangles is unique.  (3) Equal points are one corner, the lowest index of them.  (4) Segments may overlap, touch,
// and have points on them, which divide them; two that cross elsewhere throw CrossingSegments.  (5) Points that are all
// on one line have no triangle.
// A coordinate that is NaN or infinite throws NonFinite, an index beyond the points Error.
// Source: RTCD 12.5.1; docs/triangulation.md; docs/sections.md.
// Cost: n log n expected, about a microsecond a point; with segments, what these cross as well.  Bounded by n^2 signs.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "plumb/arith/error.hpp"
#include "plumb/certify/exact_point.hpp"

namespace plumb {

/// The indices of a segment's ends.
using PlanarSegment = std::array<std::uint32_t, 2>;

struct PlanarTriangulation {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Indices of points, counterclockwise.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// The triangle over the edge from corner k to the next one, or none.
  std::vector<std::array<std::uint32_t, 3>> neighbors;
  /// The least index of a segment that covers that edge, or none.  Empty where no segments were given.
  std::vector<std::array<std::uint32_t, 3>> segments;
  /// For each point the lowest index of those that equal it.
  std::vector<std::uint32_t> same;
};

/// Two segments have a point in common that is none of the points given; the text names both, and the place.
struct CrossingSegments : Error {
  CrossingSegments(std::uint32_t one, std::uint32_t other, ExactPoint2 common);
  std::array<std::uint32_t, 2> segments;  // ascending
  ExactPoint2 place;
};

PlanarTriangulation delaunay(std::span<const Point2> points);
PlanarTriangulation delaunay(std::span<const Point2> points, std::span<const PlanarSegment> segments);

}  // namespace plumb
