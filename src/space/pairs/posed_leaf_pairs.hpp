// Which triangles of two leaves meet, where the meshes have been moved?
//
// Law: of all pairs of their slots exactly those whose exact images meet are told, each once; of a leaf with itself
// those of two slots.
// Source: RTCD 3.2, 6.3.3, 5.2.10.
// Cost: a posed box for each triangle, and some 300 ns for each pair whose boxes meet.
#pragma once

#include <utility>
#include <vector>

#include "plumb/space/bvh/descend_pairs.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/pairs/leaf_pairs.hpp"
#include "space/pairs/posed_neighbors.hpp"

namespace plumb::space {

/// What a search asks of two leaves: which slots' triangles meet.
template <class Mesh = Bvh>
class PosedLeafPairs {
 public:
  PosedLeafPairs(const PosedMeshOf<Mesh>& a, const PosedMeshOf<Mesh>& b, bool is_own) : a_(a), b_(b), is_own_(is_own) {}

  /// Of leaves in such boxes.  take(TrianglePair, SlotPair) of each pair; it may say Descent::stop.
  template <class Node, class Take>
  Descent operator()(const Node& leaf_a, const Aabb3& box_a, const Node& leaf_b, const Aabb3& box_b, const Take& take) {
    read(a_, leaf_a, box_b, slots_a_);
    if (slots_a_.empty()) return Descent::go_on;
    read(b_, leaf_b, box_a, slots_b_);
    for (const PosedSlot& p : slots_a_) {
      for (const PosedSlot& q : slots_b_) {
        if (is_own_ && leaf_a.link == leaf_b.link && q.slot <= p.slot) continue;
        if (is_own_ && a_.bvh.number(p.slot) == b_.bvh.number(q.slot)) continue;  // one triangle in two slots
        if (!boxes_meet(p.box, q.box)) continue;
        const Relation relation = is_own_ ? relate_flattened(a_.bvh.vertices.view(), a_.bvh.corners_of(p.slot),
                                                             a_.bvh.corners_of(q.slot), *a_.pose.matrix())
                                          : query::relate(a_.triangle(p.slot), b_.triangle(q.slot));
        if (relation == Relation::disjoint) continue;
        std::uint32_t item_a = a_.bvh.number(p.slot), item_b = b_.bvh.number(q.slot);
        if (is_own_ && item_b < item_a) std::swap(item_a, item_b);
        if (take(TrianglePair{item_a, item_b, relation}, SlotPair{p.slot, q.slot}) == Descent::stop)
          return Descent::stop;
      }
    }
    return Descent::go_on;
  }

 private:
  struct PosedSlot {
    std::uint32_t slot;
    Aabb3 box;
  };

  /// Into `all` those of a leaf whose boxes meet that of the other leaf.
  template <class Node>
  static void read(const PosedMeshOf<Mesh>& mesh, const Node& leaf, const Aabb3& other, std::vector<PosedSlot>& all) {
    all.clear();
    for (std::uint32_t s = leaf.link; s < leaf.link + leaf.count; ++s) {
      const Aabb3 box = around(mesh.triangle(s));
      if (boxes_meet(box, other)) all.push_back({s, box});
    }
  }

  const PosedMeshOf<Mesh>&a_, &b_;
  bool is_own_;
  std::vector<PosedSlot> slots_a_, slots_b_;
};

}  // namespace plumb::space
