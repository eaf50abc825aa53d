// How is a polygon cut into triangles?
//
// Laws: a face of n corners gives n - 2 triangles on its own corners: no vertex is invented or left out, and each edge
// of the face is an edge of just one of them, in the same direction.  Seen along an axis, every point is covered as
// often as the face winds around it; so a face that projects to a simple polygon is tiled, by triangles of positive
// area, corners on straight edges included: a fan about its first corner if that tiles it, else its constrained
// Delaunay triangulation.  A face that touches itself, at keyhole bridges to holes, say, is tiled as well; what joins
// its parts has no area.  The axis is that of the largest normal component, or another one where that one shows edges
// that cross.  Where every one does, or all corners are on one line, the face becomes a fan, and is counted.
// Source: RTCD 12.5.1, 12.5.1.1; src/surface/planar/cut_ring.hpp.
// Cost: linear for triangles, quadrilaterals and faces that a fan tiles, otherwise n log n expected.
// Bounded by n^2 signs a face.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"

namespace plumb {

/// `fans`, if given, gets the number of faces that no axis shows as a simple polygon.
TriangleMesh triangulate(const PolygonMesh& mesh, std::uint64_t* fans = nullptr);

/// Triangles of one face, given by its corners, put at the end of `out`.  False when it became a fan.
bool triangulate_face(std::span<const Point3> vertices, std::span<const std::uint32_t> corners,
                      std::vector<TriangleMesh::Triangle>& out);

}  // namespace plumb
