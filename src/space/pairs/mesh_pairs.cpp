// Pairs of nodes down to some hundred parts of the work; each part down to its leaves; then all pairs in order.
#include "plumb/space/pairs/mesh_pairs.hpp"

#include <algorithm>

#include "plumb/query/overlap/triangle.hpp"
#include "plumb/query/section/intersection.hpp"
#include "plumb/space/bvh/descend_pairs.hpp"
#include "plumb/space/pairs/neighbors.hpp"
#include "space/bvh/pair_parts.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/pairs/pair_answers.hpp"
#include "space/pairs/pair_slots.hpp"

namespace plumb {
namespace space {
namespace {

constexpr std::size_t parts_wanted = 512;

struct MeshView {
  explicit MeshView(const Bvh& bvh)
      : nodes(bvh.tree.nodes.view()),
        items(bvh.tree.items.view()),
        triangles(bvh.triangles.view()),
        vertices(bvh.vertices.view()),
        frame(bvh.tree.frame) {}
  [[nodiscard]] Triangle3 triangle(std::size_t slot) const {
    const Bvh::Corners& c = triangles[slot];
    return {vertices[c[0]], vertices[c[1]], vertices[c[2]]};
  }
  std::span<const BoxNode> nodes;
  std::span<const std::uint32_t> items;
  std::span<const Bvh::Corners> triangles;
  /// In doubles, outside of the frame.
  [[nodiscard]] Aabb3 box_of(const BoxNode& n) const {
    if (frame.exponent() != 0) return frame.outside(n.box());
    return {{n.min[0], n.min[1], n.min[2]}, {n.max[0], n.max[1], n.max[2]}};
  }
  std::span<const Point3> vertices;
  BoxFrame frame;
};

/// Of one frame.
bool nodes_meet(const BoxNode& a, const BoxNode& b) {
  const auto on = [&](std::size_t k) {
    return static_cast<int>(a.min[k] <= b.max[k]) & static_cast<int>(b.min[k] <= a.max[k]);
  };
  return (on(0) & on(1) & on(2)) != 0;
}

/// What a search asks of two leaves: which slots' triangles meet.
class LeafPairs {
 public:
  LeafPairs(const MeshView& a, const MeshView& b, bool is_own) : a_(a), b_(b), is_own_(is_own) {}

  /// take(TrianglePair) of each pair; it may say Descent::stop.
  template <class Take>
  Descent operator()(const BoxNode& leaf_a, const BoxNode& leaf_b, const Take& take) {
    boxes_a_.read(a_, leaf_a, b_.box_of(leaf_b));
    if (boxes_a_.n == 0) return Descent::go_on;
    boxes_b_.read(b_, leaf_b, a_.box_of(leaf_a));
    const bool same_leaf = is_own_ && leaf_a.link == leaf_b.link;
    for (std::size_t i = 0; i < boxes_a_.n; ++i) {
      for (std::size_t k = same_leaf ? i + 1 : 0; k < boxes_b_.n; ++k) {
        if (!boxes_meet(boxes_a_.box[i], boxes_b_.box[k])) continue;
        const std::uint32_t slot_a = boxes_a_.slot[i], slot_b = boxes_b_.slot[k];
        const Relation relation = is_own_ ? relate_in_mesh(a_.vertices, a_.triangles[slot_a], b_.triangles[slot_b])
                                          : relate(a_.triangle(slot_a), b_.triangle(slot_b));
        if (relation == Relation::disjoint) continue;
        std::uint32_t item_a = a_.items[slot_a], item_b = b_.items[slot_b];
        if (is_own_ && item_b < item_a) std::swap(item_a, item_b);
        if (take(TrianglePair{item_a, item_b, relation}) == Descent::stop) return Descent::stop;
      }
    }
    return Descent::go_on;
  }

 private:
  /// A leaf's triangles whose boxes meet that of the other leaf.
  struct LeafBoxes {
    void read(const MeshView& mesh, const BoxNode& leaf, const Aabb3& other) {
      n = 0;
      if (box.size() <= leaf.count) {  // a leaf of a file may have any number
        box.resize(leaf.count + std::size_t{1});
        slot.resize(leaf.count + std::size_t{1});
      }
      for (std::uint32_t s = leaf.link; s < leaf.link + leaf.count; ++s) {
        box[n] = box_around(mesh.triangles[s], mesh.vertices);
        slot[n] = s;
        n += boxes_meet(box[n], other) ? 1 : 0;
      }
    }
    std::size_t n = 0;
    std::vector<Aabb3> box;  // as many as a leaf has, and one behind
    std::vector<std::uint32_t> slot;
  };

  const MeshView &a_, &b_;
  bool is_own_;
  LeafBoxes boxes_a_, boxes_b_;
};

/// A search of two trees, or of one with itself where `own` is set.
class PairSearch {
 public:
  PairSearch(const char* function, const Bvh& a, const Bvh& b, bool own, const PairOptions& options)
      : function_(function), a_(a), b_(b), own_(own), options_(options) {}

  /// begin(n), then take(part, pair) for each pair that was asked for, from several threads; parts are below n.
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
        return leaves(leaf_a, leaf_b, [&](const TrianglePair& pair) {
          return pair.relation == Relation::touching && !options_.touching ? Descent::go_on : take(part, pair);
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

}  // namespace
}  // namespace space

std::vector<TrianglePair> intersecting_pairs(const Bvh& a, const Bvh& b, const PairOptions& options) {
  return space::all_pairs(space::PairSearch("intersecting_pairs", a, b, false, options), a.triangles.size(),
                          options.execution);
}
std::vector<TrianglePair> self_intersecting_pairs(const Bvh& mesh, const PairOptions& options) {
  return space::all_pairs(space::PairSearch("self_intersecting_pairs", mesh, mesh, true, options),
                          mesh.triangles.size(), options.execution);
}

PairCount count_intersecting_pairs(const Bvh& a, const Bvh& b, const PairOptions& options) {
  return space::counted_pairs(space::PairSearch("count_intersecting_pairs", a, b, false, options), options.execution);
}
PairCount count_self_intersecting_pairs(const Bvh& mesh, const PairOptions& options) {
  return space::counted_pairs(space::PairSearch("count_self_intersecting_pairs", mesh, mesh, true, options),
                              options.execution);
}

std::optional<TrianglePair> any_intersecting_pair(const Bvh& a, const Bvh& b, const PairOptions& options) {
  return space::any_pair(space::PairSearch("any_intersecting_pair", a, b, false, options));
}
std::optional<TrianglePair> any_self_intersecting_pair(const Bvh& mesh, const PairOptions& options) {
  return space::any_pair(space::PairSearch("any_self_intersecting_pair", mesh, mesh, true, options));
}

std::vector<Intersection3> intersections(const Bvh& a, const Bvh& b, std::span<const TrianglePair> pairs,
                                         const PairOptions& options) {
  const std::vector<std::uint32_t> slots_a = space::slots_of(a), slots_b = space::slots_of(b);
  space::require_pairs(pairs, slots_a.size(), slots_b.size());
  std::vector<Intersection3> common(pairs.size());
  constexpr std::size_t part_size = 256;
  const std::size_t parts = space::blocks_of(pairs.size(), part_size);
  space::for_parts("intersections", options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t to = std::min(pairs.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i) {
      common[i] = intersection(a.triangle(slots_a[pairs[i].a]), b.triangle(slots_b[pairs[i].b]));
    }
  });
  return common;
}

}  // namespace plumb
