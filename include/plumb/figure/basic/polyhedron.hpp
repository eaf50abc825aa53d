// Point in polyhedron: is this mesh a convex polyhedron, and is a point in it?
//
// Laws: (1) what convex_polyhedron returns is proved convex by exact signs (figure/basic/convexity.hpp); the mesh is
// unchanged. (2) A point is inside when it is strictly below every face, outside when it is above some.
// convex_polyhedron throws InvalidShape where the mesh is not convex, naming the face, the ridge or the vertex;
// check_polyhedron the same of a struct that was filled in by hand, and where its lists are not those of its mesh.
// Source: RTCD 3.8, 3.8.1.
// Cost: O(n log n), by sorting edges; locate is linear in the faces.  Bounded by n log n operations for the making and
// the check, n signs for locate, on integers as long as the exponents' span.
#pragma once

#include <string_view>

#include "plumb/figure/basic/convex_polyhedron.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

/// Faces counterclockwise seen from outside; they may lie in one plane with others, and corners on straight edges.
ConvexPolyhedron3 convex_polyhedron(PolygonMesh mesh);
ConvexPolyhedron3 convex_polyhedron(const TriangleMesh& mesh);

/// Throws InvalidShape where it is not what convex_polyhedron makes of its mesh, NonFinite where a vertex is no point; the
/// text begins with the name of who asks.
void check_polyhedron(const ConvexPolyhedron3& polyhedron, std::string_view function = "check_polyhedron");

Location locate(const ConvexPolyhedron3& polyhedron, const Point3& p);
bool contains(const ConvexPolyhedron3& polyhedron, const Point3& p);

}  // namespace plumb
