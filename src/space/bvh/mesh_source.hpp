// Where do the triangles of a search stand?  As they were built, or under a pose; so that a search is written once.
//
//   with_source("first_hit", "mesh", view, [&](const auto& source) { return first_of(source, ray); });
//
// Laws: (1) f is called with the Bvh or CompactBvh where it stands, under the identity too, else with a PosedMeshOf it.
// (2) tree_of, slots_in, number_of and triangle_of are those of the mesh; triangle_of one under a pose is a PosedTriangle,
// and box_of contains its exact image.
// Throws as posed_mesh.hpp says, where the pose is none.
// Cost: a branch, a copy of a pose.
#pragma once

#include "plumb/space/bvh/mesh_view.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/bvh/slot_boxes.hpp"

namespace plumb::space {

template <class Source>
inline constexpr bool is_posed_source = requires(const Source& s) {
  s.pose;
};

template <class... Meshes, class F>
decltype(auto) with_source(const char* function, const char* name, const ViewOfMesh<Meshes...>& view, const F& f) {
  return view.visit([&]<class Mesh>(const Mesh& mesh) -> decltype(auto) {
    const MeshPose* pose = view.pose();
    if (pose == nullptr || *pose == MeshPose(identity_pose)) return f(mesh);
    require_pose(function, name, *pose);
    return f(PosedMeshOf<Mesh>(mesh, *pose));
  });
}

/// The mesh that a source is of.
template <class Source>
const auto& mesh_of(const Source& source) {
  if constexpr (is_posed_source<Source>) {
    return source.bvh;
  } else {
    return source;
  }
}

/// Around a node's image.
template <class Source>
Aabb3 box_of_node(const Source& source, const BoxNode& node) {
  if constexpr (is_posed_source<Source>) {
    return around(source, node);
  } else {
    return source.tree.frame.outside(node.box());
  }
}
inline Aabb3 box_of(const Triangle3& t) { return box_around(t.a, t.b, t.c); }
inline Aabb3 box_of(const PosedTriangle& t) { return around(t); }

}  // namespace plumb::space
