// Cutting a solid by a plane: which two closed meshes are on its sides, exactly?
//
//   const SplitSolid halves = split(resolve(mesh), Plane3{{1, 2, 3}, 0.5});
//   const RoundedMesh upper = round(halves.above);
//
// By a mesh, subtract(mesh, knife) and intersect(mesh, knife) are the parts outside and within.
// Laws: (1) both are closed and wound outward, as an operation makes them, and lie on their sides of the plane; their
// volumes are together that of the solid.  (2) Where the plane cuts, both have the same corners: of edges with the
// plane, and vertices in it.  (3) What is cut of a triangle has its source; triangles in the plane have cut_face.
// (4) A face in the plane bounds one of the two; where the solid only touches the plane the other has nothing of it.
// The mesh is one that an operation made.  One that is not closed, or crosses itself in the plane, throws InvalidShape;
// so does a plane without a normal.
// Source: RTCD 8.3.4.
// Cost: a rational a vertex; some 10 us a triangle that is cut; n log n for what lies in the plane.  Bounded by n^2 signs.
#pragma once

#include "plumb/query/section/planes.hpp"
#include "plumb/surface/solid/exact_mesh.hpp"

namespace plumb {

struct SplitSolid {
  ExactMesh above, below;  // on the side of the normal, and on the other
};

/// The source of triangles that a plane made.
inline constexpr SourceFace cut_face{0xFFFFFFFFU, 0xFFFFFFFFU};

SplitSolid split(const ExactMesh& mesh, const AnyPlane3& plane);

}  // namespace plumb
