// Where are the vertices of a Voronoi diagram?  The centers of the circles of a Delaunay triangulation, exactly.
//
//   const PlanarTriangulation t = delaunay(points);
//   const std::vector<ExactPoint2> centers = voronoi_vertices(points, t);
//
// Laws: centers[f] is as far from each corner of triangle f as from the others, and no point is nearer to it; triangles
// whose corners are on one circle have equal centers.  The diagram's edges join the centers of neighbors; beyond the
// hull they go on without end, at right angles to its edges.
// Source: RTCD 12.5.1; docs/triangulation.md.
// Cost: rational numbers, some microseconds a triangle.  Nothing is searched.
#pragma once

#include <span>
#include <vector>

#include "plumb/surface/planar/delaunay.hpp"

namespace plumb {

/// The triangulation must be one of these points.
std::vector<ExactPoint2> voronoi_vertices(std::span<const Point2> points, const PlanarTriangulation& triangulation);

}  // namespace plumb
