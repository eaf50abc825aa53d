// Which two sources does a question of pairs search?  Of one kind, and without poses where the answer is the same.
//
// Laws: (1) f is called with two meshes that stand, or with two under poses, both a Bvh or both a CompactBvh.  (2)
// Under one regular pose meshes stand to one another as they do without it, so that poses are left out where relations
// are asked; so does one mesh to itself.
// Throws as posed_mesh.hpp says, where a pose is none.
// Cost: a determinant; of a Bvh beside a CompactBvh a compact tree.
#pragma once

#include "plumb/space/bvh/mesh_view.hpp"
#include "space/bvh/mesh_source.hpp"

namespace plumb::space {

/// What is asked: relations, which a common pose keeps, or places.
enum class Asked : bool { relations, places };

template <class Mesh, class F>
decltype(auto) with_sources_of_one_kind(const char* function, Asked asked, const Mesh& a, const MeshPose* pose_a,
                                        const Mesh& b, const MeshPose* pose_b, const F& f) {
  const auto posed = [](const Mesh& mesh, const MeshPose* pose) {
    return pose == nullptr ? PosedMeshOf<Mesh>(mesh) : PosedMeshOf<Mesh>(mesh, *pose);
  };
  if (pose_a == nullptr && pose_b == nullptr) return f(a, b);
  const PosedMeshOf<Mesh> under_a = posed(a, pose_a), under_b = posed(b, pose_b);
  const bool alike = are_moved_alike(function, under_a, under_b);
  return alike && asked == Asked::relations ? f(a, b) : f(under_a, under_b);
}

template <class... Meshes, class F>
decltype(auto) with_sources(const char* function, const ViewOfMesh<Meshes...>& a, const ViewOfMesh<Meshes...>& b,
                            const F& f, Asked asked = Asked::relations) {
  return a.visit([&]<class A>(const A& mesh_a) -> decltype(auto) {
    return b.visit([&]<class B>(const B& mesh_b) -> decltype(auto) {
      if constexpr (std::is_same_v<A, B>) {
        return with_sources_of_one_kind(function, asked, mesh_a, a.pose(), mesh_b, b.pose(), f);
      } else if constexpr (std::is_same_v<A, Bvh>) {
        return with_sources_of_one_kind(function, asked, compact(mesh_a), a.pose(), mesh_b, b.pose(), f);
      } else {
        return with_sources_of_one_kind(function, asked, mesh_a, a.pose(), compact(mesh_b), b.pose(), f);
      }
    });
  });
}

/// Of one mesh, to be asked about itself.
template <class... Meshes, class F>
decltype(auto) with_own_source(const char* function, const ViewOfMesh<Meshes...>& view, const F& f) {
  return view.visit([&]<class Mesh>(const Mesh& mesh) -> decltype(auto) {
    if (view.pose() == nullptr) return f(mesh);
    const PosedMeshOf<Mesh> posed(mesh, *view.pose());
    return is_moved_regularly(function, posed) ? f(mesh) : f(posed);
  });
}

}  // namespace plumb::space
