// How do segments divide the plane?  Where they cross and overlap, the edges between, the faces, and their windings.
//
//   const PlanarArrangement a = arrange_segments(segments);
//   for (std::size_t t = 0; t < a.triangles.size(); ++t)
//     if (a.windings[a.face_of[t]] > 0) use(a.triangles[t]);
//
// Laws: (1) vertices are the ends of segments and the points that segments have in common, exact, each once, in
// lexicographic order.  (2) Edges meet in vertices only, and each is there once, from its lower vertex to the higher,
// however many segments cover it; they are in the order of their vertices.  (3) Faces are the parts of the plane that
// are left, number 0 the one without bounds.  (4) Triangles cover the convex hull, and each lies in one face; they are
// the constrained Delaunay triangulation of the edges (delaunay.hpp).  (5) Where as many segments leave each vertex as
// come in, each face has a winding number: how often the segments go around it counterclockwise.  Otherwise `windings`
// is empty.
// A coordinate that is NaN or infinite throws NonFinite.
// Source: RTCD 5.1.9.1, 12.5.1; docs/triangulation.md.
// Cost: that of overlapping_pairs for the segments' boxes, then n log n expected in the vertices.  Bounded by n^4
// signs, for n segments may have n^2 vertices.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/certify/exact_point.hpp"
#include "plumb/figure/basic/linear.hpp"

namespace plumb {

struct PlanarArrangement {
  std::vector<ExactPoint2> vertices;
  /// Vertices of each segment's ends.
  std::vector<std::array<std::uint32_t, 2>> ends;
  std::vector<std::array<std::uint32_t, 2>> edges;
  /// The faces on an edge's left and on its right.
  std::vector<std::array<std::uint32_t, 2>> sides;
  /// How many segments go along an edge, less those that go back.
  std::vector<std::int32_t> weights;
  std::uint32_t faces = 1;
  std::vector<std::int32_t> windings;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// The face of each triangle.
  std::vector<std::uint32_t> face_of;
};

PlanarArrangement arrange_segments(std::span<const Segment2> segments);

}  // namespace plumb
