// A mesh that has been moved: a tree and a pose, without a copy and without rounding a vertex.
//
//   const RigidPose turn{{2, 0, 0, 1}, {5, 0, 0}};
//   intersecting_pairs({a, turn}, b);        // a Bvh alone stands where it was built
//
// PosedCompactMesh is the same of a CompactBvh.
// Laws: (1) every question is answered for the exact images of the vertices, whatever the pose: of a matrix that is not
// quite orthonormal, with shear, a mirror, a projection onto a plane, a line or a point, and beyond the largest double;
// of a turn by a quaternion and of a chain of them, which are rigid (arith/rigid_pose.hpp).  (2) So a common pose of two
// meshes changes no pair and no relation, where it is regular.  (3) The tree stays as it is and must outlive the
// PosedMesh, which keeps its pose.
// A pose that has a number that is NaN or infinite throws NonFinite, the quaternion zero InvalidShape, naming it, from the
// question.
// Source: RTCD 3.2, 6.3.3.
// Cost: nothing of a matrix, some 100 ns of a rigid pose and more of each link.  Boxes of nodes are posed as they are
// needed, rounded outward; triangles by arithmetic that knows its error, which is several times that of a mesh that
// stands.  Nothing is searched.
#pragma once

#include <array>
#include <variant>

#include "plumb/arith/interval.hpp"
#include "plumb/figure/basic/pose_view.hpp"
#include "plumb/space/bvh/bvh.hpp"
#include "plumb/space/bvh/compact_tree.hpp"

namespace plumb {

/// A pose of space of any kind, kept.
class MeshPose {
 public:
  /// What takes (x, y, z) to a coordinate of its image: three factors and what is added.
  using Rows = std::array<std::array<Interval, 4>, 3>;

  MeshPose(const Pose& pose = identity_pose) : is_(pose) {}              // NOLINT: a pose is one
  MeshPose(const RigidPose& pose) : is_(pose), rows_(rows_of(pose)) {}   // NOLINT
  MeshPose(const RigidChain& pose) : is_(pose), rows_(rows_of(pose)) {}  // NOLINT

  /// A rigid one has none.
  [[nodiscard]] const Pose* matrix() const { return std::get_if<Pose>(&is_); }
  /// A rigid one has intervals here, around its exact numbers.
  [[nodiscard]] const Rows& rows() const { return rows_; }
  /// f(pose), a Pose, a RigidPose or a RigidChain.
  template <class F>
  decltype(auto) visit(F f) const {
    return std::visit(f, is_);
  }
  [[nodiscard]] PoseView view() const {
    return visit([](const auto& pose) { return PoseView(pose); });
  }
  [[nodiscard]] AnyPoseView any_view() const {
    return visit([](const auto& pose) { return AnyPoseView(&pose); });
  }
  friend bool operator==(const MeshPose& a, const MeshPose& b) { return a.is_ == b.is_; }

 private:
  static Rows rows_of(const RigidPose& pose);
  static Rows rows_of(const RigidChain& pose);
  static constexpr std::array<Interval, 4> none{Interval(0), Interval(0), Interval(0), Interval(0)};

  std::variant<Pose, RigidPose, RigidChain> is_;
  Rows rows_{none, none, none};
};

/// A triangle of a mesh under its pose.
struct PosedTriangle {
  Triangle3 shape;
  const MeshPose& pose;
};

template <class Mesh>
struct PosedMeshOf {
  const Mesh& bvh;
  MeshPose pose;

  PosedMeshOf(const Mesh& b, const Pose& p = identity_pose) : bvh(b), pose(p) {}  // NOLINT: a Bvh is one
  PosedMeshOf(const Mesh& b, const MeshPose& p) : bvh(b), pose(p) {}
  PosedMeshOf(Mesh&&, const Pose& = identity_pose) = delete;  // which would not live
  PosedMeshOf(Mesh&&, const MeshPose&) = delete;

  /// This is the triangle in a slot; the mesh must outlive it.
  [[nodiscard]] PosedTriangle triangle(std::size_t slot) const { return {bvh.triangle(slot), pose}; }
};

using PosedMesh = PosedMeshOf<Bvh>;
using PosedCompactMesh = PosedMeshOf<CompactBvh>;

}  // namespace plumb
