// What a front is walked through: two meshes where they stand or have been moved, or one with itself.
//
// Cost: nothing of its own for meshes that stand; for moved ones a box for each node in the front.
#pragma once

#include <vector>

#include "plumb/space/coherence/pair_front.hpp"
#include "space/bvh/parts.hpp"
#include "space/pairs/leaf_pairs.hpp"
#include "space/pairs/posed_slots.hpp"

namespace plumb::space {

class StandingScene {
 public:
  class Leaves {
   public:
    explicit Leaves(const StandingScene& scene) : scene_(scene), pairs_(scene.a_, scene.b_, scene.is_own_) {}
    template <class Take>
    void operator()(NodePair pair, const Take& take) {
      const BoxNode &a = scene_.a_.nodes[pair.a], &b = scene_.b_.nodes[pair.b];
      pairs_(a, scene_.a_.box_of(a), b, scene_.b_.box_of(b), take);
    }

   private:
    const StandingScene& scene_;
    LeafPairs<SlotMesh<Bvh>> pairs_;
  };

  StandingScene(const Bvh& a, const Bvh& b, bool is_own)
      : a_(a), b_(b), is_own_(is_own), is_one_frame_(a.tree.frame == b.tree.frame) {}

  [[nodiscard]] std::span<const BoxNode> nodes_a() const { return a_.nodes; }
  [[nodiscard]] std::span<const BoxNode> nodes_b() const { return b_.nodes; }
  [[nodiscard]] bool is_own() const { return is_own_; }
  [[nodiscard]] bool meets(NodePair pair) const {
    const BoxNode &a = a_.nodes[pair.a], &b = b_.nodes[pair.b];
    if (is_own_ && pair.a == pair.b) return true;
    return is_one_frame_ ? nodes_meet(a, b) : boxes_meet(a_.box_of(a), b_.box_of(b));
  }
  template <class Take>
  void replace(NodePair pair, const Take& take) const {
    if (is_own_) {
      replace_own_pair(a_.nodes, pair, take);
    } else {
      replace_pair(a_.nodes, b_.nodes, descend_larger{}, pair, take);
    }
  }
  [[nodiscard]] Leaves leaves() const { return Leaves(*this); }
  void prepare(Front&, Execution) {}

 private:
  SlotMesh<Bvh> a_, b_;
  bool is_own_, is_one_frame_;
};

class MovedScene {
 public:
  class Leaves {
   public:
    explicit Leaves(const MovedScene& scene) : scene_(scene), pairs_(scene.slots_a_, scene.slots_b_, scene.is_own_) {}
    template <class Take>
    void operator()(NodePair pair, const Take& take) {
      pairs_(scene_.nodes_a_[pair.a], scene_.box_a(pair.a), scene_.nodes_b_[pair.b], scene_.box_b(pair.b), take);
    }

   private:
    const MovedScene& scene_;
    LeafPairs<PosedSlots<Bvh>> pairs_;
  };

  /// Of one mesh with itself its pose is to be singular: else it is the question without.
  MovedScene(const PosedMesh& a, const PosedMesh& b, bool is_own)
      : a_(a),
        b_(b),
        slots_a_(a),
        slots_b_(b),
        is_own_(is_own),
        nodes_a_(a.bvh.tree.nodes.view()),
        nodes_b_(b.bvh.tree.nodes.view()) {}

  [[nodiscard]] std::span<const BoxNode> nodes_a() const { return nodes_a_; }
  [[nodiscard]] std::span<const BoxNode> nodes_b() const { return nodes_b_; }
  [[nodiscard]] bool is_own() const { return is_own_; }
  [[nodiscard]] bool meets(NodePair pair) const {
    return (is_own_ && pair.a == pair.b) || boxes_meet(box_a(pair.a), box_b(pair.b));
  }
  template <class Take>
  void replace(NodePair pair, const Take& take) const {
    if (is_own_) return replace_own_pair(nodes_a_, pair, take);
    const auto larger = [&](const BoxNode&, const BoxNode&) { return larger_posed(box_a(pair.a), box_b(pair.b)); };
    replace_pair(nodes_a_, nodes_b_, larger, pair, take);
  }
  [[nodiscard]] Leaves leaves() const { return Leaves(*this); }

  /// Poses the boxes of all nodes in the front; of all nodes where it is the roots, and they meet.
  void prepare(Front& front, Execution execution) {
    needed_a_ = &front.boxes_a;
    needed_b_ = is_own_ ? needed_a_ : &front.boxes_b;
    begin(a_, front.boxes_a);
    pose(a_, front, &NodePair::a, front.boxes_a, execution);
    NeededBoxes& boxes_b = is_own_ ? front.boxes_a : front.boxes_b;
    if (!is_own_) begin(b_, boxes_b);
    pose(b_, front, &NodePair::b, boxes_b, execution);
    if (front.pairs.size() > 1 || !meets({0, 0})) return;
    pose_rest(a_, front.boxes_a, execution);
    if (!is_own_) pose_rest(b_, boxes_b, execution);
  }

 private:
  static void begin(const PosedMesh& mesh, NeededBoxes& needed) {
    const std::size_t n = mesh.bvh.tree.nodes.view().size();
    if (needed.boxes.size() != n) {
      needed.boxes.resize(n);
      needed.posed.reset(n);
    }
    needed.posed.begin();
  }
  static void pose(const PosedMesh& mesh, const Front& front, std::uint32_t NodePair::*side, NeededBoxes& needed,
                   Execution execution) {
    std::vector<std::uint32_t> which;
    for (const NodePair& pair : front.pairs) {
      if (needed.posed.visit(pair.*side)) which.push_back(pair.*side);
    }
    pose(mesh, which, needed, execution);
  }
  static void pose_rest(const PosedMesh& mesh, NeededBoxes& needed, Execution execution) {
    std::vector<std::uint32_t> which;
    for (std::uint32_t i = 0; i < needed.boxes.size(); ++i) {
      if (needed.posed.visit(i)) which.push_back(i);
    }
    pose(mesh, which, needed, execution);
  }
  static void pose(const PosedMesh& mesh, std::span<const std::uint32_t> which, NeededBoxes& needed,
                   Execution execution) {
    const std::span<const BoxNode> nodes = mesh.bvh.tree.nodes.view();
    for_blocks(execution, which.size(), 1 << 10, [&](std::size_t, std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) needed.boxes[which[i]] = around(mesh, nodes[which[i]]);
    });
  }

  [[nodiscard]] Aabb3 box_a(std::uint32_t i) const {
    return needed_a_->posed.visited(i) ? needed_a_->boxes[i] : around(a_, nodes_a_[i]);
  }
  [[nodiscard]] Aabb3 box_b(std::uint32_t i) const {
    return needed_b_->posed.visited(i) ? needed_b_->boxes[i] : around(b_, nodes_b_[i]);
  }

  const PosedMesh &a_, &b_;
  PosedSlots<Bvh> slots_a_, slots_b_;
  bool is_own_;
  std::span<const BoxNode> nodes_a_, nodes_b_;
  const NeededBoxes *needed_a_ = nullptr, *needed_b_ = nullptr;
};

}  // namespace plumb::space
