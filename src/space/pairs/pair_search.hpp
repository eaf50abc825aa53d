// Which triangles of two meshes meet, or of one: pairs of nodes down to some hundred parts of the work, each part down
// to its leaves.  By the wide forms, but for trees in two frames.
//
// Law: each pair of triangles that meet is told once, on any number of threads.
// Source: RTCD 6.3.3.
// Cost: that of wide_pairs.hpp; of two frames that of descend_pairs.hpp and leaf_pairs.hpp.
#pragma once

#include <type_traits>
#include <vector>

#include "plumb/space/bvh/descend_pairs.hpp"
#include "space/bvh/pair_parts.hpp"
#include "space/bvh/parts.hpp"
#include "space/pairs/leaf_pairs.hpp"
#include "space/pairs/wide_pairs.hpp"

namespace plumb::space {

inline constexpr std::size_t parts_wanted = 512;

/// A search of two trees, or of one with itself where `own` is set.
template <class Mesh>
class PairSearch {
 public:
  PairSearch(const char* function, const Mesh& a, const Mesh& b, bool own, const PairOptions& options)
      : function_(function), a_(a), b_(b), own_(own), options_(options) {}

  /// begin(n), then take(part, pair, slots) for each pair that was asked for, from several threads; parts are below n.
  template <class Begin, class Take>
  void run(Execution execution, const Begin& begin, const Take& take, std::size_t wanted = parts_wanted) const {
    if (a_.nodes.empty() || b_.nodes.empty()) return;
    if (a_.frame != b_.frame) {
      run_by_twos(
          execution, [&](const BoxNode& a, const BoxNode& b) { return boxes_meet(a_.box_of(a), b_.box_of(b)); }, begin,
          take, wanted);
    } else if constexpr (std::is_same_v<Mesh, Bvh>) {
      run_wide(execution, begin, take, wanted);
    } else {
      run_by_twos(
          execution, [](const BoxNode& a, const BoxNode& b) { return nodes_meet(a, b); }, begin, take, wanted);
    }
  }

 private:
  /// What a pair that was found is, to who asked.
  template <class Take>
  auto asked_for(std::size_t part, const Take& take) const {
    return [this, part, &take](const TrianglePair& pair, SlotPair slots) {
      return pair.relation == Relation::touching && !options_.touching ? Descent::go_on : take(part, pair, slots);
    };
  }

  template <class Begin, class Take>
  void run_wide(Execution execution, const Begin& begin, const Take& take, std::size_t wanted) const {
    const WideChildren children(a_.wide_nodes, b_.wide_nodes, own_);
    std::vector<WidePair> all{{wide_root, wide_root}}, next;
    for (bool any = true; any && all.size() < wanted; all.swap(next)) {
      any = false;
      next.clear();
      for (const WidePair& pair : all) {
        if (pair.is_leaves()) {
          next.push_back(pair);
        } else {
          any = true;
          children(pair, [&](const WidePair& p) { next.push_back(p); });
        }
      }
    }
    begin(all.size());
    for_parts(function_, execution, options_.progress, all.size(), [&](std::size_t part) {
      WideLeafPairs leaves(a_, b_, own_);
      const auto found = asked_for(part, take);
      std::vector<WidePair> later{all[part]};
      while (!later.empty()) {
        const WidePair pair = later.back();
        later.pop_back();
        if (!pair.is_leaves()) {
          children(pair, [&](const WidePair& p) { later.push_back(p); });
          continue;
        }
        if (!later.empty() && later.back().is_leaves()) leaves.fetch(later.back());
        if (leaves(pair, found) == Descent::stop) {
          return Descent::stop;
        }
      }
      return Descent::go_on;
    });
  }

  template <class Meet, class Begin, class Take>
  void run_by_twos(Execution execution, const Meet& meet, const Begin& begin, const Take& take,
                   std::size_t wanted) const {
    const auto down = [&](const auto& pair, const auto& next) {
      if (own_) {
        replace_own_pair(a_.nodes, pair, next);
      } else {
        replace_pair(a_.nodes, b_.nodes, descend_larger{}, pair, next);
      }
    };
    const auto all = pair_parts(a_.nodes, b_.nodes, wanted, down, meet);
    begin(all.size());
    for_parts(function_, execution, options_.progress, all.size(), [&](std::size_t part) {
      LeafPairs leaves(a_, b_, own_);
      const auto found = asked_for(part, take);
      const auto visit = [&](const BoxNode& leaf_a, const BoxNode& leaf_b) { return leaves(leaf_a, leaf_b, found); };
      return descend_from(a_.nodes, b_.nodes, all[part], down, meet, visit);
    });
  }

  const char* function_;
  SlotMesh<Mesh> a_, b_;
  bool own_;
  const PairOptions& options_;
};

}  // namespace plumb::space
