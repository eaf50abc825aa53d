// Which triangles of two meshes meet, or of one: pairs of nodes down to some hundred parts of the work, each part down
// to its leaves.
//
// Law: each pair of triangles that meet is told once, on any number of threads.
// Source: RTCD 6.3.3.
// Cost: that of descend_pairs.hpp and leaf_pairs.hpp.
#pragma once

#include <vector>

#include "plumb/space/bvh/descend_pairs.hpp"
#include "space/bvh/pair_parts.hpp"
#include "space/bvh/parts.hpp"
#include "space/pairs/leaf_pairs.hpp"

namespace plumb::space {

inline constexpr std::size_t parts_wanted = 512;

/// A search of two trees, or of one with itself where `own` is set.
class PairSearch {
 public:
  PairSearch(const char* function, const Bvh& a, const Bvh& b, bool own, const PairOptions& options)
      : function_(function), a_(a), b_(b), own_(own), options_(options) {}

  /// begin(n), then take(part, pair, slots) for each pair that was asked for, from several threads; parts are below n.
  template <class Begin, class Take>
  void run(Execution execution, const Begin& begin, const Take& take) const {
    if (a_.nodes.empty() || b_.nodes.empty()) return;
    if (a_.frame == b_.frame) {
      run_with(
          execution, [](const BoxNode& a, const BoxNode& b) { return nodes_meet(a, b); }, begin, take);
    } else {
      const auto meet = [&](const BoxNode& a, const BoxNode& b) { return boxes_meet(a_.box_of(a), b_.box_of(b)); };
      run_with(execution, meet, begin, take);
    }
  }

 private:
  template <class Take>
  void replace(NodePair pair, const Take& take) const {
    if (own_) {
      replace_own_pair(a_.nodes, pair, take);
    } else {
      replace_pair(a_.nodes, b_.nodes, descend_larger{}, pair, take);
    }
  }

  template <class Meet, class Begin, class Take>
  void run_with(Execution execution, const Meet& meet, const Begin& begin, const Take& take) const {
    const auto down = [&](NodePair pair, const auto& next) { replace(pair, next); };
    const std::vector<NodePair> all = pair_parts(a_.nodes, b_.nodes, parts_wanted, down, meet);
    begin(all.size());
    for_parts(function_, execution, options_.progress, all.size(), [&](std::size_t part) {
      LeafPairs leaves(a_, b_, own_);
      const auto visit = [&](const BoxNode& leaf_a, const BoxNode& leaf_b) {
        return leaves(leaf_a, leaf_b, [&](const TrianglePair& pair, SlotPair slots) {
          return pair.relation == Relation::touching && !options_.touching ? Descent::go_on : take(part, pair, slots);
        });
      };
      return descend_from(a_.nodes, b_.nodes, all[part], down, meet, visit);
    });
  }

  const char* function_;
  MeshView a_, b_;
  bool own_;
  const PairOptions& options_;
};

}  // namespace plumb::space
