// Can these polygons be divided, and do they bound a solid?
//
// Laws: exact.  Vertices at one place are one vertex to whether a mesh is closed.
// Cost: k^2 signs for a polygon of k corners, none for a triangle; a sort of the edges.
#pragma once

#include "plumb/figure/basic/mesh.hpp"

namespace plumb::space {

/// Throws InvalidShape for a face that is not planar or not convex, and what require_mesh throws.
void require_convex_faces(const PolygonMesh& mesh);

/// Throws InvalidShape, naming an edge that an odd number of triangles has.
void require_closed(const TriangleMesh& mesh);

/// The corners of each face, joined to its first.
TriangleMesh fans_of(const PolygonMesh& mesh);

}  // namespace plumb::space
