// The triangles of a tree's slots, as searches of pairs ask them, of a Bvh or a CompactBvh.
//
// Law: a slot's triangle is the one that the tree keeps there.
// Source: RTCD 6.6.
// Cost: a load, and of a CompactBvh a mask, for each number.
#pragma once

#include <span>

#include "plumb/query/overlap/overlap.hpp"
#include "plumb/space/bvh/descend_compact_pairs.hpp"
#include "plumb/space/pairs/neighbors.hpp"
#include "space/bvh/slot_boxes.hpp"

namespace plumb::space {

/// The corners in slots, out of their packed numbers.
struct PackedCorners {
  PackedView numbers;
  [[nodiscard]] Bvh::Corners operator[](std::size_t slot) const {
    return {numbers[3 * slot], numbers[3 * slot + 1], numbers[3 * slot + 2]};
  }
};

/// How the parts of a mesh are kept: each is asked by its slot.
template <class Mesh>
struct MeshParts;
template <>
struct MeshParts<Bvh> {
  std::span<const BoxNode> nodes;
  std::span<const WideNode<8>> wide_nodes;
  std::span<const std::uint32_t> items;
  std::span<const Bvh::Corners> triangles;
  explicit MeshParts(const Bvh& bvh)
      : nodes(bvh.tree.nodes.view()),
        wide_nodes(bvh.wide.nodes.view()),
        items(bvh.tree.items.view()),
        triangles(bvh.triangles.view()) {}
};
template <>
struct MeshParts<CompactBvh> {
  CompactPlaces nodes;
  PackedView items;
  PackedCorners triangles;
  explicit MeshParts(const CompactBvh& bvh)
      : nodes(bvh.tree), items(bvh.numbers.view()), triangles{bvh.corners.view()} {}
};

template <class Mesh>
struct SlotMesh : MeshParts<Mesh> {
  explicit SlotMesh(const Mesh& bvh) : MeshParts<Mesh>(bvh), vertices(bvh.vertices.view()), frame(bvh.tree.frame) {}
  [[nodiscard]] Triangle3 triangle(std::size_t slot) const {
    const Bvh::Corners& c = this->triangles[slot];
    return {vertices[c[0]], vertices[c[1]], vertices[c[2]]};
  }
  [[nodiscard]] std::uint32_t number(std::uint32_t slot) const { return this->items[slot]; }
  [[nodiscard]] Aabb3 box(std::uint32_t slot) const { return box_around(this->triangles[slot], vertices); }
  [[nodiscard]] Relation relation(std::uint32_t slot, const SlotMesh& other, std::uint32_t slot_of_other) const {
    return relate(triangle(slot), other.triangle(slot_of_other));
  }
  [[nodiscard]] Relation relation_in_mesh(std::uint32_t a, std::uint32_t b) const {
    return relate_in_mesh(vertices, this->triangles[a], this->triangles[b]);
  }
  /// In doubles, outside of the frame.
  [[nodiscard]] Aabb3 box_of(const BoxNode& n) const {
    if (frame.exponent() != 0) return frame.outside(n.box());
    return {{n.min[0], n.min[1], n.min[2]}, {n.max[0], n.max[1], n.max[2]}};
  }
  std::span<const Point3> vertices;
  BoxFrame frame;
};

}  // namespace plumb::space
