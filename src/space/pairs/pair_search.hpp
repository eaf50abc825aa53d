// Which triangles of two meshes meet, or of one: pairs of nodes down to some hundred parts of the work, each part down
// to its leaves.  By the wide forms, but for trees that are compact, in two frames or under poses.
//
// Law: each pair of triangles that meet (of exact images, under poses) is told once, on any number of threads.
// Source: RTCD 3.2, 4.2.6, 6.3.3.
// Cost: that of wide_pairs.hpp, else of descend_pairs.hpp and leaf_pairs.hpp; under a pose a box for each node that is
// looked at.
#pragma once

#include <optional>
#include <type_traits>
#include <vector>

#include "plumb/space/bvh/descend_pairs.hpp"
#include "space/bvh/mesh_source.hpp"
#include "space/bvh/pair_parts.hpp"
#include "space/bvh/parts.hpp"
#include "space/closest/posed_places.hpp"
#include "space/pairs/leaf_pairs.hpp"
#include "space/pairs/posed_slots.hpp"
#include "space/pairs/wide_pairs.hpp"

namespace plumb::space {

inline constexpr std::size_t parts_wanted = 512;

template <class Source>
struct PairSlotsOf {
  using type = SlotMesh<Source>;
};
template <class Mesh>
struct PairSlotsOf<PosedMeshOf<Mesh>> {
  using type = PosedSlots<Mesh>;
};

/// A search of two sources, or of one with itself where `own` is set: then a pose is singular, else none.
template <class Source>
class PairSearch {
 public:
  PairSearch(const char* function, const Source& a, const Source& b, bool own, const PairOptions& options)
      : function_(function), source_(a), a_(a), b_(b), own_(own), options_(options) {}

  /// begin(n), then take(part, pair, slots) for each pair that was asked for, from several threads; parts are below n.
  template <class Begin, class Take>
  void run(Execution execution, const Begin& begin, const Take& take, std::size_t wanted = parts_wanted) const {
    if constexpr (is_posed_source<Source>) {
      run_posed(execution, begin, take, wanted);
    } else {
      if (a_.nodes.empty() || b_.nodes.empty()) return;
      if (a_.frame != b_.frame) {
        const auto meet = [&](const BoxNode& a, const BoxNode& b) { return boxes_meet(a_.box_of(a), b_.box_of(b)); };
        run_by_twos(execution, a_.nodes, b_.nodes, descend_larger{}, meet, begin, take, wanted);
      } else if constexpr (std::is_same_v<Source, Bvh>) {
        run_wide(execution, begin, take, wanted);
      } else {
        const auto meet = [](const BoxNode& a, const BoxNode& b) { return nodes_meet(a, b); };
        run_by_twos(execution, a_.nodes, b_.nodes, descend_larger{}, meet, begin, take, wanted);
      }
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
    StarsOfSearch<Source> stars(source_, own_, execution);
    for_parts(function_, execution, options_.progress, all.size(), [&](std::size_t part) {
      WideLeafPairs leaves(a_, b_, own_, stars.before(part));
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

  template <class Begin, class Take>
  void run_posed(Execution execution, const Begin& begin, const Take& take, std::size_t wanted) const {
    const auto root_box = [](const auto& mesh) {
      return around(mesh.pose, mesh.bvh.tree.frame.outside(mesh.bvh.tree.box()));
    };
    if (a_.mesh.bvh.slots() == 0 || b_.mesh.bvh.slots() == 0) return;
    if (!own_ && !boxes_meet(root_box(a_.mesh), root_box(b_.mesh))) return;  // before there is memory for any other
    using Places = PosedPlaces<std::remove_cvref_t<decltype(a_.mesh.bvh)>>;
    const Places as(a_.mesh);
    std::optional<Places> others;
    const Places& bs = own_ ? as : others.emplace(b_.mesh);
    const auto larger = [](const auto& a, const auto& b) { return larger_posed(a.box, b.box); };
    const auto meet = [](const auto& a, const auto& b) { return boxes_meet(a.box, b.box); };
    run_by_twos(execution, as, bs, larger, meet, begin, take, wanted);
  }

  template <class Nodes, class Larger, class Meet, class Begin, class Take>
  void run_by_twos(Execution execution, const Nodes& as, const Nodes& bs, const Larger& larger, const Meet& meet,
                   const Begin& begin, const Take& take, std::size_t wanted) const {
    const auto down = [&](const auto& pair, const auto& next) {
      if (own_) {
        replace_own_pair(as, pair, larger, next);
      } else {
        replace_pair(as, bs, larger, pair, next);
      }
    };
    const auto all = pair_parts(as, bs, wanted, down, meet);
    begin(all.size());
    StarsOfSearch<Source> stars(source_, own_, execution);
    for_parts(function_, execution, options_.progress, all.size(), [&](std::size_t part) {
      LeafPairs leaves(a_, b_, own_, stars.before(part));
      const auto found = asked_for(part, take);
      const auto visit = [&](const auto& leaf_a, const auto& leaf_b) {
        return leaves(leaf_a, a_.box_of(leaf_a), leaf_b, b_.box_of(leaf_b), found);
      };
      return descend_from(as, bs, all[part], down, meet, visit);
    });
  }

  const char* function_;
  const Source& source_;  // the first
  typename PairSlotsOf<Source>::type a_, b_;
  bool own_;
  const PairOptions& options_;
};

}  // namespace plumb::space
