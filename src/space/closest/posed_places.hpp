// The nodes of a tree that has been moved, each in the box that its pose makes of its own; for pairs of them
// (descend_pairs.hpp).
//
// Laws: (1) a node's box contains the exact image of what is below it.  (2) Boxes are made as they are asked for, by any
// number of threads, and kept.
// Source: RTCD 4.2.6, 6.3.3.
// Cost: a posed box for each node that is looked at; memory for all, of which none is touched that is not.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>

#include "plumb/space/bvh/descend_compact_pairs.hpp"
#include "space/bvh/posed_box.hpp"

namespace plumb::space {

/// Rows of boxes, each made by whoever asks first.
template <std::size_t width>
class KeptBoxes {
 public:
  using Row = std::array<Aabb3, width>;

  explicit KeptBoxes(std::size_t rows)
      : rows_(std::make_unique_for_overwrite<Row[]>(rows)), states_(std::make_unique<std::atomic<State>[]>(rows)) {}

  /// take(row), made by make(row) where nobody has; a thread that comes while another makes it makes its own.
  template <class Make, class Take>
  decltype(auto) visit(std::size_t i, const Make& make, const Take& take) const {
    State seen = states_[i].load(std::memory_order_acquire);
    if (seen == State::none && states_[i].compare_exchange_strong(seen, State::begun)) {
      make(rows_[i]);
      states_[i].store(State::made, std::memory_order_release);
      seen = State::made;
    }
    if (seen == State::made) return take(std::as_const(rows_[i]));
    Row own;
    make(own);
    return take(std::as_const(own));
  }

 private:
  enum class State : std::uint8_t { none, begun, made };
  std::unique_ptr<Row[]> rows_;
  std::unique_ptr<std::atomic<State>[]> states_;
};

/// A node in a box of doubles, with the link and the count that it has in its tree.
struct BoxedNode {
  Aabb3 box;
  std::uint32_t link, count;
  [[nodiscard]] bool is_leaf() const { return count != 0; }
};

template <class Mesh>
class PosedPlaces;

/// A binary tree's are named by their numbers.
template <>
class PosedPlaces<Bvh> {
 public:
  using Node = BoxedNode;

  explicit PosedPlaces(const PosedMesh& mesh)
      : mesh_(mesh), nodes_(mesh.bvh.tree.nodes.view()), boxes_(nodes_.size()) {}
  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] Node operator[](std::uint32_t i) const {
    const BoxNode& node = nodes_[i];
    const auto make = [&](auto& row) { row[0] = around(mesh_, node); };
    return boxes_.visit(i, make, [&](const auto& row) { return Node{row[0], node.link, node.count}; });
  }

  friend bool is_same_place(const PosedPlaces&, std::uint32_t i, std::uint32_t k) { return i == k; }
  friend std::uint32_t root_place(const PosedPlaces&) { return 0; }
  template <class Take>
  friend void for_children(const PosedPlaces& places, std::uint32_t i, const Take& take) {
    for_children(places.nodes_, i, take);
  }

 private:
  const PosedMesh& mesh_;
  std::span<const BoxNode> nodes_;
  KeptBoxes<1> boxes_;
};

/// A compact one's are named by what their parent says of them.
template <>
class PosedPlaces<CompactBvh> {
 public:
  using Node = BoxedNode;

  explicit PosedPlaces(const PosedCompactMesh& mesh)
      : mesh_(mesh),
        nodes_(mesh.bvh.tree.nodes.view()),
        boxes_(nodes_.size()),
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
    const auto make = [&](auto& row) {
      for (std::size_t i = 0; i < CompactNode::width; ++i) {
        if (node.has(i)) row[i] = around(places.mesh_.pose, places.mesh_.bvh.tree.frame.outside(node.box(i)));
      }
    };
    places.boxes_.visit(place.link, make, [&](const auto& row) {
      for (std::size_t i = CompactNode::width; i-- > 0;) {
        if (node.has(i)) take(Node{row[i], node.link(i), i < node.inner ? 0 : std::uint32_t{node.count[i]}});
      }
    });
  }

 private:
  const PosedCompactMesh& mesh_;
  std::span<const CompactNode> nodes_;
  KeptBoxes<CompactNode::width> boxes_;
  Node root_;
};

template <>
inline constexpr std::size_t most_children<PosedPlaces<CompactBvh>> = CompactNode::width;
template <>
inline constexpr std::size_t most_levels<PosedPlaces<CompactBvh>> = CompactTree::most_levels;

}  // namespace plumb::space
