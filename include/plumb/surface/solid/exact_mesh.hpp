// Exact mesh: a surface whose vertices are exact points, and which triangle of which mesh each face is a piece of.
//
//   const ExactMesh turned = exact_mesh(part, RigidPose{{2, 0, 0, 1}, {0.5, 0, 0}});     // not rounded
//   const ExactMesh chain = subtract(unite(turned, exact_mesh(other)), exact_mesh(bore));
//   const RoundedMesh rounded = round(chain);                                       // once, at its end
//
// Laws: (1) vertices ascend lexicographically, no two equal; one that doubles hold is held as Point3, any other in
// rational coordinates: so equal meshes are told alike.  (2) Triangles begin with their smallest vertex and ascend.
// (3) exact_mesh is the mesh, or its exact image under a pose: equal vertices are one, and a mirrored solid's triangles are
// turned, so that what was wound outward stays so.  (4) exact_volume is that of the solid where the mesh is closed and wound outward, negative where wound inward.
// NaN and infinity throw NonFinite, a quaternion zero and a triangle that names no vertex InvalidShape, an image beyond
// the largest double BeyondDoubles.
// Source: RTCD 2.2.1.
// Cost: a volume takes some microseconds a triangle, and more where many vertices are no doubles: its denominator is
// that of all of them.  An image takes some microseconds a vertex.  Nothing is searched.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "plumb/arith/rational.hpp"
#include "plumb/certify/exact_point.hpp"
#include "plumb/figure/basic/mesh.hpp"
#include "plumb/figure/basic/pose_view.hpp"

namespace plumb {

/// A triangle of one of the meshes that were given, by their numbers.
struct SourceFace {
  std::uint32_t mesh, triangle;
  friend auto operator<=>(const SourceFace&, const SourceFace&) = default;
};

struct ExactMesh {
  std::vector<ExactPoint3> vertices;
  std::vector<TriangleMesh::Triangle> triangles;
  std::vector<SourceFace> sources;  // of each triangle
};

Rational exact_volume(const ExactMesh& mesh);

/// A source names the triangle of the mesh as number 0.
ExactMesh exact_mesh(const TriangleMesh& mesh, PoseView pose = identity_pose);
/// Sources stay as they are.
ExactMesh exact_mesh(const ExactMesh& mesh, PoseView pose);
template <PoseOfSpace By>
ExactMesh exact_mesh(const Posed<TriangleMesh, By>& mesh) {
  return exact_mesh(mesh.shape, mesh.pose);
}

}  // namespace plumb
