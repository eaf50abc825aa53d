// Coplanar pieces: which mesh of fewer triangles bounds the same solid, exactly?
//
//   const RoundedMesh r = round(merge_pieces(unite(a, b)));
//
// Operations cut faces into pieces; this makes one polygon of what lies in one plane, and triangles of that.
// Laws: (1) the surface is the same set of points, and the mesh is as an operation makes it: closed, wound outward, in
// order.  (2) Neighbors over an edge of two triangles that lie in one plane, decided exactly, are one polygon; edges of
// more triangles stay.  (3) A vertex goes where one polygon surrounds it and no other has it, or where all that end
// there run straight through it between the same two neighbors; one that another has in a polygon's midst stays: so no
// T-junction comes of it.  (4) A polygon of n corners and h holes has n + 2 h - 2 triangles, and two more for each vertex
// in its midst: those of the constrained Delaunay triangulation seen along an axis; where there were no more, they stay
// as they were.  (5) A new triangle's source is the least of those of its polygon.
// A mesh whose triangles overlap in a plane, as no operation makes one, throws InvalidShape; one without a
// source for each triangle throws UnequalLengths.
// Source: RTCD 2.2.1.
// Cost: some signs an edge; n log n expected for polygons that are triangulated anew.  Bounded by n^2 signs.
#pragma once

#include "plumb/surface/solid/exact_mesh.hpp"

namespace plumb {

ExactMesh merge_pieces(const ExactMesh& mesh);

}  // namespace plumb
