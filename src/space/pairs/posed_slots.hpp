// The slots of a mesh that has been moved, as leaf_pairs.hpp asks them.
//
// Law: two that meet are those whose exact images do.
// Source: RTCD 3.2, 5.2.10.
// Cost: a posed box for each triangle, and some 300 ns for each pair whose boxes meet.
#pragma once

#include "plumb/space/pairs/mesh_pairs.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/pairs/posed_neighbors.hpp"

namespace plumb::space {

template <class Mesh>
struct PosedSlots {
  explicit PosedSlots(const PosedMeshOf<Mesh>& moved) : mesh(moved) {}

  [[nodiscard]] std::uint32_t number(std::uint32_t slot) const { return mesh.bvh.number(slot); }
  [[nodiscard]] Aabb3 box(std::uint32_t slot) const { return around(mesh.triangle(slot)); }
  /// Of a node whose box is posed.
  template <class Node>
  [[nodiscard]] const Aabb3& box_of(const Node& node) const {
    return node.box;
  }
  [[nodiscard]] Relation relation(std::uint32_t slot, const PosedSlots& other, std::uint32_t slot_of_other) const {
    return query::relate(mesh.triangle(slot), other.mesh.triangle(slot_of_other));
  }
  /// How do two of this mesh lie, beyond the vertices that they share?
  [[nodiscard]] Relation relation_in_mesh(std::uint32_t a, std::uint32_t b) const {
    return relate_flattened(mesh.bvh.vertices.view(), mesh.bvh.corners_of(a), mesh.bvh.corners_of(b),
                            *mesh.pose.matrix());
  }

  const PosedMeshOf<Mesh>& mesh;
};

}  // namespace plumb::space
