// Which triangles of two leaves meet?
//
// Law: of all pairs of their slots exactly those whose triangles meet are told, each once; of a leaf with itself those
// of two slots.
// Source: RTCD 6.3.3, 5.2.10.
// Cost: a box a slot, a comparison of boxes of doubles a pair, and relate for those whose boxes meet.
#pragma once

#include <utility>
#include <vector>

#include "plumb/query/overlap/overlap.hpp"
#include "plumb/space/bvh/descend_compact_pairs.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "plumb/space/pairs/neighbors.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/pairs/simple_stars.hpp"
#include "space/pairs/slot_mesh.hpp"

namespace plumb::space {

/// Where a pair was found.
struct SlotPair {
  std::uint32_t a, b;
};

/// Do the triangles of two slots meet?  Of a SlotMesh or PosedSlots.
template <class Slots>
class JudgedPair {
 public:
  /// `stars` are of a mesh that is asked about itself, where there are any.
  JudgedPair(const Slots& a, const Slots& b, bool is_own, const SimpleStars* stars)
      : a_(a), b_(b), is_own_(is_own), stars_(stars) {}

  /// take(TrianglePair, SlotPair) where they do; it may say Descent::stop.
  template <class Take>
  Descent operator()(SlotPair slots, const Take& take) const {
    std::uint32_t item_a = a_.number(slots.a), item_b = b_.number(slots.b);
    if (is_own_ && item_a == item_b) return Descent::go_on;  // one triangle in two slots
    if constexpr (requires { a_.triangles; }) {
      if (stars_ != nullptr && stars_->tell_apart(a_.triangles[slots.a], a_.triangles[slots.b])) return Descent::go_on;
    }
    const Relation relation = is_own_ ? a_.relation_in_mesh(slots.a, slots.b) : a_.relation(slots.a, b_, slots.b);
    if (relation == Relation::disjoint) return Descent::go_on;
    if (is_own_ && item_b < item_a) std::swap(item_a, item_b);
    return take(TrianglePair{item_a, item_b, relation}, slots);
  }

 private:
  const Slots &a_, &b_;
  bool is_own_;
  const SimpleStars* stars_;
};

/// What a search asks of two leaves: which slots' triangles meet.
template <class Slots>
class LeafPairs {
 public:
  LeafPairs(const Slots& a, const Slots& b, bool is_own, const SimpleStars* stars = nullptr)
      : a_(a), b_(b), is_own_(is_own), judge_(a, b, is_own, stars) {}

  /// Calls take(TrianglePair, SlotPair) for each pair of leaves in such boxes; it may say Descent::stop.
  template <class Node, class Take>
  Descent operator()(const Node& leaf_a, const Aabb3& box_a, const Node& leaf_b, const Aabb3& box_b, const Take& take) {
    boxes_a_.read(a_, leaf_a, box_b);
    if (boxes_a_.n == 0) return Descent::go_on;
    boxes_b_.read(b_, leaf_b, box_a);
    const bool same_leaf = is_own_ && leaf_a.link == leaf_b.link;
    for (std::size_t i = 0; i < boxes_a_.n; ++i) {
      for (std::size_t k = same_leaf ? i + 1 : 0; k < boxes_b_.n; ++k) {
        if (!boxes_meet(boxes_a_.box[i], boxes_b_.box[k])) continue;
        if (judge_({boxes_a_.slot[i], boxes_b_.slot[k]}, take) == Descent::stop) return Descent::stop;
      }
    }
    return Descent::go_on;
  }

 private:
  /// A leaf's triangles whose boxes meet that of the other leaf.
  struct LeafBoxes {
    template <class Node>
    void read(const Slots& slots, const Node& leaf, const Aabb3& other) {
      n = 0;
      if (box.size() <= leaf.count) {  // a leaf of a file may have any number
        box.resize(leaf.count + std::size_t{1});
        slot.resize(leaf.count + std::size_t{1});
      }
      for (std::uint32_t s = leaf.link; s < leaf.link + leaf.count; ++s) {
        box[n] = slots.box(s);
        slot[n] = s;
        n += boxes_meet(box[n], other) ? 1 : 0;
      }
    }
    std::size_t n = 0;
    std::vector<Aabb3> box;  // as many as a leaf has, and one behind
    std::vector<std::uint32_t> slot;
  };

  const Slots &a_, &b_;
  bool is_own_;
  JudgedPair<Slots> judge_;
  LeafBoxes boxes_a_, boxes_b_;
};

}  // namespace plumb::space
