// Which triangles of two moved meshes meet, or of one: pairs of posed boxes down to leaves, as in pair_search.hpp.
//
// Law: each pair of triangles whose exact images meet is told once, on any number of threads.
// Source: RTCD 3.2, 4.2.6, 6.3.3.
// Cost: a posed box for each node that is looked at, and that of descend_pairs.hpp and posed_leaf_pairs.hpp.
#pragma once

#include <optional>

#include "plumb/space/bvh/descend_pairs.hpp"
#include "space/bvh/pair_parts.hpp"
#include "space/bvh/parts.hpp"
#include "space/closest/posed_places.hpp"
#include "space/pairs/pair_search.hpp"
#include "space/pairs/posed_leaf_pairs.hpp"

namespace plumb::space {

/// Of two meshes, or of one with itself under a singular pose.
template <class Mesh>
class PosedPairSearch {
 public:
  PosedPairSearch(const char* function, const PosedMeshOf<Mesh>& a, const PosedMeshOf<Mesh>& b, bool own,
                  const PairOptions& options)
      : function_(function), a_(a), b_(b), own_(own), options_(options) {}

  /// begin(n), then take(part, pair, slots) for each pair that was asked for, from several threads; parts are below n.
  template <class Begin, class Take>
  void run(Execution execution, const Begin& begin, const Take& take, std::size_t wanted = parts_wanted) const {
    if (a_.bvh.slots() == 0 || b_.bvh.slots() == 0) return;
    if (!own_ && !boxes_meet(root_box(a_), root_box(b_))) return;  // before there is memory for any other
    const PosedPlaces<Mesh> as(a_);
    std::optional<PosedPlaces<Mesh>> others;
    const PosedPlaces<Mesh>& bs = own_ ? as : others.emplace(b_);
    const auto larger = [](const auto& a, const auto& b) { return larger_posed(a.box, b.box); };
    const auto down = [&](const auto& pair, const auto& next) {
      if (own_) return replace_own_pair(as, pair, larger, next);
      replace_pair(as, bs, larger, pair, next);
    };
    const auto meet = [](const auto& a, const auto& b) { return boxes_meet(a.box, b.box); };
    const auto all = pair_parts(as, bs, wanted, down, meet);
    begin(all.size());
    for_parts(function_, execution, options_.progress, all.size(), [&](std::size_t part) {
      PosedLeafPairs leaves(a_, b_, own_);
      const auto visit = [&](const auto& leaf_a, const auto& leaf_b) {
        return leaves(leaf_a, leaf_a.box, leaf_b, leaf_b.box, [&](const TrianglePair& pair, SlotPair slots) {
          return pair.relation == Relation::touching && !options_.touching ? Descent::go_on : take(part, pair, slots);
        });
      };
      return descend_from(as, bs, all[part], down, meet, visit);
    });
  }

 private:
  static Aabb3 root_box(const PosedMeshOf<Mesh>& mesh) {
    return around(mesh.pose, mesh.bvh.tree.frame.outside(mesh.bvh.tree.box()));
  }

  const char* function_;
  const PosedMeshOf<Mesh>&a_, &b_;
  bool own_;
  const PairOptions& options_;
};

}  // namespace plumb::space
