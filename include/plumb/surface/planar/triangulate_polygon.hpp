// Which triangles make up a polygon, with holes or without, in the plane or in a plane of space?
//
//   triangulate(polygon)                             // indices of its vertices
//   triangulate(holed, WindingRule::nonzero)         // of the outer polygon's vertices, then of the holes'
//   triangulate(points, first, WindingRule::positive)   // rings points[first[k]] ... points[first[k + 1] - 1]
//
// Laws: (1) the triangles have area, overlap nowhere and cover exactly the points around which the rings wind as the
// rule says: their areas add up to that of the polygon.  (2) Every vertex on the boundary of what is covered is a
// corner; equal vertices are one, the lowest index of them.  (3) They are the constrained Delaunay triangulation of
// the rings' edges (delaunay.hpp), seen along an axis where the polygon is in space; so they are unique.  (4) In the
// plane triangles turn counterclockwise; in space as the rings wind around them, so that the polygon keeps its side.
// Rings may nest, touch, share edges and turn back on themselves; where edges cross between vertices, CrossingSegments
// is thrown, with edge i from vertex i on, or they are divided there by triangulate_with_crossings.  A ring of fewer
// than three vertices throws InvalidShape, as does a polygon in space that is not planar; a coordinate that is NaN or
// infinite NonFinite.
// Source: RTCD 12.5.1, 12.5.1.1; docs/triangulation.md.
// Cost: n log n expected; with crossings that of arrange_segments.  Bounded by n^2 signs, with
// crossings by n^4 signs.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/polygon.hpp"
#include "plumb/surface/planar/delaunay.hpp"

namespace plumb {

/// Which winding numbers are inside: 1, 3, -1, ...; all but 0; all above 0.
enum class WindingRule : unsigned char { odd, nonzero, positive };

using CornerTriangles = std::vector<std::array<std::uint32_t, 3>>;

CornerTriangles triangulate(const Polygon2& polygon, WindingRule rule = WindingRule::odd);
CornerTriangles triangulate(const HoledPolygon2& polygon, WindingRule rule = WindingRule::odd);
CornerTriangles triangulate(const Polygon3& polygon, WindingRule rule = WindingRule::odd);
CornerTriangles triangulate(const HoledPolygon3& polygon, WindingRule rule = WindingRule::odd);

/// `first` has a number more than there are rings; the last is that of the points.
CornerTriangles triangulate(std::span<const Point2> points, std::span<const std::uint32_t> first,
                            WindingRule rule = WindingRule::odd);
CornerTriangles triangulate(std::span<const Point3> points, std::span<const std::uint32_t> first,
                            WindingRule rule = WindingRule::odd);

/// Triangles between exact points, which are in lexicographic order.
struct ExactTriangles {
  std::vector<ExactPoint2> vertices;
  CornerTriangles triangles;
};

/// Edges that cross are divided where they do.  Vertices are those of arrange_segments.
ExactTriangles triangulate_with_crossings(const Polygon2& polygon, WindingRule rule = WindingRule::odd);
ExactTriangles triangulate_with_crossings(const HoledPolygon2& polygon, WindingRule rule = WindingRule::odd);

}  // namespace plumb
