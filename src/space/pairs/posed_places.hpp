// The nodes of a tree that has been moved, each in the box that its pose makes of its own; for pairs of them
// (descend_pairs.hpp).
//
// Law: a node's box contains the exact image of what is below it.
// Source: RTCD 4.2.6, 6.3.3.
// Cost: posed_boxes, once; it must outlive the places.
#pragma once

#include <span>

#include "plumb/space/bvh/descend_compact_pairs.hpp"
#include "space/bvh/posed_box.hpp"

namespace plumb::space {

template <class Mesh>
class PosedPlaces;

/// Of a binary tree: named by their numbers.
template <>
class PosedPlaces<Bvh> {
 public:
  struct Node {
    const Aabb3& box;
    std::uint32_t link, count;
    [[nodiscard]] bool is_leaf() const { return count != 0; }
  };

  PosedPlaces(const PosedMesh& mesh, std::span<const Aabb3> boxes)
      : nodes_(mesh.bvh.tree.nodes.view()), boxes_(boxes) {}
  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] Node operator[](std::uint32_t i) const { return {boxes_[i], nodes_[i].link, nodes_[i].count}; }

  friend bool is_same_place(const PosedPlaces&, std::uint32_t i, std::uint32_t k) { return i == k; }
  friend std::uint32_t root_place(const PosedPlaces&) { return 0; }
  template <class Take>
  friend void for_children(const PosedPlaces& places, std::uint32_t i, const Take& take) {
    for_children(places.nodes_, i, take);
  }

 private:
  std::span<const BoxNode> nodes_;
  std::span<const Aabb3> boxes_;
};

/// Of a compact one: named by what their parent says of them.
template <>
class PosedPlaces<CompactBvh> {
 public:
  struct Node {
    Aabb3 box;
    std::uint32_t link, count;
    [[nodiscard]] bool is_leaf() const { return count != 0; }
  };

  PosedPlaces(const PosedCompactMesh& mesh, std::span<const Aabb3> boxes)
      : nodes_(mesh.bvh.tree.nodes.view()),
        boxes_(boxes),
        root_{around(mesh.pose, mesh.bvh.tree.frame.outside(mesh.bvh.tree.box())), 0, 0} {}
  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] const Node& operator[](const Node& place) const { return place; }

  friend bool is_same_place(const PosedPlaces&, const Node& a, const Node& b) {
    return a.link == b.link && a.count == b.count;
  }
  friend Node root_place(const PosedPlaces& places) { return places.root_; }
  template <class Take>
  friend void for_children(const PosedPlaces& places, const Node& place, const Take& take) {
    const CompactNode& node = places.nodes_[place.link];
    const std::span<const Aabb3> boxes = places.boxes_.subspan(CompactNode::width * place.link, CompactNode::width);
    for (std::size_t i = CompactNode::width; i-- > 0;) {
      if (node.has(i)) take(Node{boxes[i], node.link(i), i < node.inner ? 0 : std::uint32_t{node.count[i]}});
    }
  }

 private:
  std::span<const CompactNode> nodes_;
  std::span<const Aabb3> boxes_;
  Node root_;
};

template <>
inline constexpr std::size_t most_children<PosedPlaces<CompactBvh>> = CompactNode::width;
template <>
inline constexpr std::size_t most_levels<PosedPlaces<CompactBvh>> = CompactTree::most_levels;

}  // namespace plumb::space
