// Which triangles of two moved meshes meet, or of one: pairs of posed boxes down to leaves, as in pair_search.hpp.
//
// Law: each pair of triangles whose exact images meet is told once, on any number of threads.
// Source: RTCD 3.2, 4.2.6, 6.3.3.
// Cost: a posed box for each node, and that of descend_pairs.hpp and posed_leaf_pairs.hpp.
#pragma once

#include <vector>

#include "plumb/space/bvh/descend_pairs.hpp"
#include "space/bvh/pair_parts.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/pairs/pair_search.hpp"
#include "space/pairs/posed_leaf_pairs.hpp"

namespace plumb::space {

/// Of two meshes, or of one with itself under a singular pose.
class PosedPairSearch {
 public:
  PosedPairSearch(const char* function, const PosedMesh& a, const PosedMesh& b, bool own, const PairOptions& options)
      : function_(function),
        a_(a),
        b_(b),
        own_(own),
        options_(options),
        nodes_a_(a.bvh.tree.nodes.view()),
        nodes_b_(b.bvh.tree.nodes.view()) {}

  /// begin(n), then take(part, pair, slots) for each pair that was asked for, from several threads; parts are below n.
  template <class Begin, class Take>
  void run(Execution execution, const Begin& begin, const Take& take) {
    if (nodes_a_.empty() || nodes_b_.empty()) return;
    boxes_a_ = posed_boxes(a_, execution);
    if (!own_) boxes_b_ = posed_boxes(b_, execution);
    const auto down = [&](NodePair pair, const auto& next) { replace(pair, next); };
    const auto meet = [&](const BoxNode& a, const BoxNode& b) { return boxes_meet(box_a(a), box_b(b)); };
    const std::vector<NodePair> all = pair_parts(nodes_a_, nodes_b_, parts_wanted, down, meet);
    begin(all.size());
    for_parts(function_, execution, options_.progress, all.size(), [&](std::size_t part) {
      PosedLeafPairs leaves(a_, b_, own_);
      const auto visit = [&](const BoxNode& leaf_a, const BoxNode& leaf_b) {
        return leaves(leaf_a, box_a(leaf_a), leaf_b, box_b(leaf_b), [&](const TrianglePair& pair, SlotPair slots) {
          return pair.relation == Relation::touching && !options_.touching ? Descent::go_on : take(part, pair, slots);
        });
      };
      return descend_from(nodes_a_, nodes_b_, all[part], down, meet, visit);
    });
  }

 private:
  [[nodiscard]] const Aabb3& box_a(const BoxNode& n) const {
    return boxes_a_[static_cast<std::size_t>(&n - nodes_a_.data())];
  }
  [[nodiscard]] const Aabb3& box_b(const BoxNode& n) const {
    return (own_ ? boxes_a_ : boxes_b_)[static_cast<std::size_t>(&n - nodes_b_.data())];
  }

  template <class Take>
  void replace(NodePair pair, const Take& take) const {
    if (own_) return replace_own_pair(nodes_a_, pair, take);
    const auto larger = [&](const BoxNode& a, const BoxNode& b) { return larger_posed(box_a(a), box_b(b)); };
    replace_pair(nodes_a_, nodes_b_, larger, pair, take);
  }

  const char* function_;
  const PosedMesh &a_, &b_;
  bool own_;
  const PairOptions& options_;
  std::span<const BoxNode> nodes_a_, nodes_b_;
  std::vector<Aabb3> boxes_a_, boxes_b_;
};

}  // namespace plumb::space
