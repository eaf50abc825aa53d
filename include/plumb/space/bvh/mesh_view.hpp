// Which mesh, kept in which way, and where does it stand?  What a question of meshes takes, so that it is stated once.
//
//   first_hit(bvh, ray), first_hit(small, ray)      a Bvh or a CompactBvh where it was built
//   first_hit({bvh, pose}, ray)                     under a Pose, a RigidPose or a RigidChain
//   intersecting_pairs({a, turn}, small)            each of two is kept and stands in a way of its own
//
// MeshView is any of them; BvhView one that is kept as a Bvh.
// Law: the answers are those of posed_mesh.hpp's exact images.  A view refers to the mesh, and to the pose of a PosedMesh;
// they must outlive it.
// Source: RTCD 3.2, 6.3.3.
// Cost: a branch; a pose in braces is kept, as posed_mesh.hpp says.  Nothing is searched.
#pragma once

#include <concepts>
#include <optional>
#include <variant>

#include "plumb/space/bvh/posed_mesh.hpp"

namespace plumb {

template <class... Meshes>
class ViewOfMesh {
  template <class Mesh>
  static constexpr bool is_one = (std::same_as<Mesh, Meshes> || ...);

 public:
  template <class Mesh>
  requires is_one<Mesh> ViewOfMesh(const Mesh& mesh) : mesh_(&mesh) {}  // NOLINT: a mesh is one
  template <class Mesh>
  requires is_one<Mesh> ViewOfMesh(const Mesh& mesh, const Pose& pose) : mesh_(&mesh), own_(pose) {}
  template <class Mesh>
  requires is_one<Mesh> ViewOfMesh(const Mesh& mesh, const MeshPose& pose) : mesh_(&mesh), own_(pose) {}
  template <class Mesh>
  requires is_one<Mesh> ViewOfMesh(const PosedMeshOf<Mesh>& mesh)  // NOLINT: so is one under a pose
      : mesh_(&mesh.bvh), given_(&mesh.pose) {}

  /// f(the mesh as it was built).
  template <class F>
  decltype(auto) visit(const F& f) const {
    return std::visit([&f](const auto* mesh) -> decltype(auto) { return f(*mesh); }, mesh_);
  }
  /// Nothing where it stands.
  [[nodiscard]] const MeshPose* pose() const { return given_ != nullptr ? given_ : own_ ? &*own_ : nullptr; }

 private:
  std::variant<const Meshes*...> mesh_;
  const MeshPose* given_ = nullptr;
  std::optional<MeshPose> own_;
};

using MeshView = ViewOfMesh<Bvh, CompactBvh>;
using BvhView = ViewOfMesh<Bvh>;

}  // namespace plumb
