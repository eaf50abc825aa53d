// A mesh that has been moved: a tree and a pose, without a copy and without rounding a vertex.
//
//   const Pose turn{{{{0.8, 0.6, 0}, {-0.6, 0.8, 0}, {0, 0, 1}}}, {5, 0, 0}};
//   intersecting_pairs({a, turn}, b);        // a Bvh alone stands where it was built
//
// PosedCompactMesh is the same of a CompactBvh.
// Laws: (1) every question is answered for the vertices matrix * p + translation of real arithmetic, whatever the
// matrix: not quite orthonormal, with shear, a mirror, a projection onto a plane, a line or a point, and beyond the
// largest double.  (2) So a common pose of two meshes changes no pair and no relation, where its matrix is regular.
// (3) The tree stays as it is and must outlive the PosedMesh; making one costs nothing.
// A pose that has a number that is NaN or infinite throws NonFinite, naming it, from the question.
// Source: RTCD 3.2, 6.3.3.
// Cost: boxes of nodes are posed as they are needed, rounded outward; triangles by arithmetic that knows its error,
// which is several times that of a mesh that stands.  Nothing is searched.
#pragma once

#include "plumb/arith/pose.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/bvh/compact_tree.hpp"

namespace plumb {

template <class Mesh>
struct PosedMeshOf {
  const Mesh& bvh;
  Pose pose;

  PosedMeshOf(const Mesh& b, const Pose& p = identity_pose) : bvh(b), pose(p) {}  // NOLINT: a Bvh is one
  PosedMeshOf(Mesh&&, const Pose& = identity_pose) = delete;                      // which would not live

  /// Of the triangle in a slot.
  [[nodiscard]] Posed<Triangle3> triangle(std::size_t slot) const { return {bvh.triangle(slot), pose}; }
};

using PosedMesh = PosedMeshOf<Bvh>;
using PosedCompactMesh = PosedMeshOf<CompactBvh>;

}  // namespace plumb
