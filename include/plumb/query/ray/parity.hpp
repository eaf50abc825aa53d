// Point in polyhedron, winding number: is the point in the solid that a closed mesh bounds, and how often does the
// surface wind around it?
//
// A ray goes out along x, moved by the vector of HitRule::half_open (query/ray/hits.hpp), so that there are no unlucky
// directions: nothing is shot again, and none of its crossings is at an edge or a vertex.
// Laws: (1) a point that is on a triangle is on the boundary, exactly.  (2) Elsewhere it is inside where the ray
// crosses an odd number of triangles; the winding number counts the crossings by their sign: one inside of a simple
// surface whose triangles turn counterclockwise seen from outside, minus one where they turn clockwise.  (3) For a
// closed mesh, in which every edge is in an even number of triangles (for the winding number: passed as often in either
// direction), this does not depend on the ray; of any other mesh it is what that ray crosses.  (4) Self-intersections,
// repeated vertices and triangles without area change nothing in that.  (5) The order of triangles, and the corner that
// each begins with, change nothing.
// A triangle that names no vertex throws InvalidShape, NaN and infinity NonFinite.
// Source: RTCD 5.4.3 (figure 5.29).
// Cost: four comparisons a triangle, some 2 ns; an exact sign for those that the ray's line passes through in the plane
// of y and z.  Bounded by n signs for n triangles, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <optional>

#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "plumb/figure/basic/relation.hpp"

namespace plumb {

Location locate(const TriangleMesh& mesh, const Point3& p);
bool contains(const TriangleMesh& mesh, const Point3& p);

/// Nothing for a point on the surface.
std::optional<std::int64_t> winding_number(const TriangleMesh& mesh, const Point3& p);

/// Is every edge in an even number of triangles?  One that names a vertex twice has no edges.  O(n log n).
bool is_closed(const TriangleMesh& mesh);
/// Is every edge passed as often in either direction?
bool is_oriented_closed(const TriangleMesh& mesh);

}  // namespace plumb
