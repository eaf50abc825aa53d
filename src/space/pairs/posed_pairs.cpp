// Under one regular pose the question without it; else pairs of posed boxes down to leaves, as in mesh_pairs.cpp.
#include "plumb/space/pairs/posed_pairs.hpp"

#include <algorithm>

#include "plumb/predicates.hpp"
#include "plumb/space/bvh/descend_pairs.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "query/section/posed_triangles.hpp"
#include "space/bvh/pair_parts.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/pairs/pair_answers.hpp"
#include "space/pairs/pair_slots.hpp"
#include "space/pairs/posed_neighbors.hpp"

namespace plumb {
namespace space {
namespace {

constexpr std::size_t posed_parts_wanted = 512;

/// Then it maps one to one, and what is in common has an image of its own.
bool is_regular(const Pose& pose) {
  const auto point = [](const Vector3& v) { return Point3{v.x, v.y, v.z}; };
  const auto& c = pose.columns;
  return orient3d(point(c[0]), point(c[1]), point(c[2]), Point3{0, 0, 0}) != Sign::zero;
}

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

  /// begin(n), then take(part, pair) for each pair that was asked for, from several threads; parts are below n.
  template <class Begin, class Take>
  void run(Execution execution, const Begin& begin, const Take& take) {
    if (nodes_a_.empty() || nodes_b_.empty()) return;
    boxes_a_ = posed_boxes(a_, execution);
    if (!own_) boxes_b_ = posed_boxes(b_, execution);
    const auto down = [&](NodePair pair, const auto& next) { replace(pair, next); };
    const auto meet = [&](const BoxNode& a, const BoxNode& b) { return boxes_meet(box_a(a), box_b(b)); };
    const std::vector<NodePair> all = pair_parts(nodes_a_, nodes_b_, posed_parts_wanted, down, meet);
    begin(all.size());
    for_parts(function_, execution, options_.progress, all.size(), [&](std::size_t part) {
      std::vector<PosedSlot> slots_a, slots_b;
      const auto visit = [&](const BoxNode& leaf_a, const BoxNode& leaf_b) {
        return on_leaves(leaf_a, leaf_b, slots_a, slots_b, [&](const TrianglePair& pair) {
          return pair.relation == Relation::touching && !options_.touching ? Descent::go_on : take(part, pair);
        });
      };
      return descend_from(nodes_a_, nodes_b_, all[part], down, meet, visit);
    });
  }

 private:
  struct PosedSlot {
    std::uint32_t slot;
    Aabb3 box;
  };

  [[nodiscard]] const Aabb3& box_a(const BoxNode& n) const {
    return boxes_a_[static_cast<std::size_t>(&n - nodes_a_.data())];
  }
  [[nodiscard]] const Aabb3& box_b(const BoxNode& n) const {
    return (own_ ? boxes_a_ : boxes_b_)[static_cast<std::size_t>(&n - nodes_b_.data())];
  }

  template <class Take>
  void replace(NodePair pair, const Take& take) const {
    if (own_) return replace_own_pair(nodes_a_, pair, take);
    const auto larger = [&](const BoxNode& a, const BoxNode& b) {  // a guess
      const auto size = [](const Aabb3& x) {
        return std::max({x.max.x - x.min.x, x.max.y - x.min.y, x.max.z - x.min.z});
      };
      return size(box_a(a)) < size(box_b(b)) ? Descend::second : Descend::first;
    };
    replace_pair(nodes_a_, nodes_b_, larger, pair, take);
  }

  /// Into `all` those of a leaf whose boxes meet that of the other leaf.
  static void read(const PosedMesh& mesh, const BoxNode& leaf, const Aabb3& other, std::vector<PosedSlot>& all) {
    all.clear();
    for (std::uint32_t s = leaf.link; s < leaf.link + leaf.count; ++s) {
      const Aabb3 box = around(mesh.triangle(s));
      if (boxes_meet(box, other)) all.push_back({s, box});
    }
  }

  template <class Take>
  Descent on_leaves(const BoxNode& leaf_a, const BoxNode& leaf_b, std::vector<PosedSlot>& slots_a,
                    std::vector<PosedSlot>& slots_b, const Take& take) const {
    read(a_, leaf_a, box_b(leaf_b), slots_a);
    if (slots_a.empty()) return Descent::go_on;
    read(b_, leaf_b, box_a(leaf_a), slots_b);
    for (const PosedSlot& p : slots_a) {
      for (const PosedSlot& q : slots_b) {
        if (own_ && leaf_a.link == leaf_b.link && q.slot <= p.slot) continue;
        if (!boxes_meet(p.box, q.box)) continue;
        const Relation relation =
            own_ ? relate_flattened(a_, p.slot, q.slot) : query::relate(a_.triangle(p.slot), b_.triangle(q.slot));
        if (relation == Relation::disjoint) continue;
        std::uint32_t item_a = a_.bvh.tree.items[p.slot], item_b = b_.bvh.tree.items[q.slot];
        if (own_ && item_b < item_a) std::swap(item_a, item_b);
        if (take(TrianglePair{item_a, item_b, relation}) == Descent::stop) return Descent::stop;
      }
    }
    return Descent::go_on;
  }

  const char* function_;
  const PosedMesh &a_, &b_;
  bool own_;
  const PairOptions& options_;
  std::span<const BoxNode> nodes_a_, nodes_b_;
  std::vector<Aabb3> boxes_a_, boxes_b_;
};

/// Is it the question without poses?
bool are_moved_alike(const char* function, const PosedMesh& a, const PosedMesh& b) {
  require_pose(function, "a", a.pose);
  require_pose(function, "b", b.pose);
  return a.pose == b.pose && is_regular(a.pose);
}
bool is_moved_regularly(const char* function, const PosedMesh& mesh) {
  require_pose(function, "mesh", mesh.pose);
  return is_regular(mesh.pose);
}

}  // namespace
}  // namespace space

std::vector<TrianglePair> intersecting_pairs(const PosedMesh& a, const PosedMesh& b, const PairOptions& options) {
  constexpr const char* function = "intersecting_pairs";
  return space::are_moved_alike(function, a, b)
             ? intersecting_pairs(a.bvh, b.bvh, options)
             : space::all_pairs(space::PosedPairSearch(function, a, b, false, options), a.bvh.triangles.size(),
                                options.execution);
}
std::vector<TrianglePair> self_intersecting_pairs(const PosedMesh& mesh, const PairOptions& options) {
  constexpr const char* function = "self_intersecting_pairs";
  return space::is_moved_regularly(function, mesh)
             ? self_intersecting_pairs(mesh.bvh, options)
             : space::all_pairs(space::PosedPairSearch(function, mesh, mesh, true, options), mesh.bvh.triangles.size(),
                                options.execution);
}

PairCount count_intersecting_pairs(const PosedMesh& a, const PosedMesh& b, const PairOptions& options) {
  constexpr const char* function = "count_intersecting_pairs";
  return space::are_moved_alike(function, a, b)
             ? count_intersecting_pairs(a.bvh, b.bvh, options)
             : space::counted_pairs(space::PosedPairSearch(function, a, b, false, options), options.execution);
}
PairCount count_self_intersecting_pairs(const PosedMesh& mesh, const PairOptions& options) {
  constexpr const char* function = "count_self_intersecting_pairs";
  return space::is_moved_regularly(function, mesh)
             ? count_self_intersecting_pairs(mesh.bvh, options)
             : space::counted_pairs(space::PosedPairSearch(function, mesh, mesh, true, options), options.execution);
}

std::optional<TrianglePair> any_intersecting_pair(const PosedMesh& a, const PosedMesh& b, const PairOptions& options) {
  constexpr const char* function = "any_intersecting_pair";
  return space::are_moved_alike(function, a, b)
             ? any_intersecting_pair(a.bvh, b.bvh, options)
             : space::any_pair(space::PosedPairSearch(function, a, b, false, options));
}
std::optional<TrianglePair> any_self_intersecting_pair(const PosedMesh& mesh, const PairOptions& options) {
  constexpr const char* function = "any_self_intersecting_pair";
  return space::is_moved_regularly(function, mesh)
             ? any_self_intersecting_pair(mesh.bvh, options)
             : space::any_pair(space::PosedPairSearch(function, mesh, mesh, true, options));
}

std::vector<Intersection3> intersections(const PosedMesh& a, const PosedMesh& b, std::span<const TrianglePair> pairs,
                                         const PairOptions& options) {
  space::require_pose("intersections", "a", a.pose);
  space::require_pose("intersections", "b", b.pose);
  const std::vector<std::uint32_t> slots_a = space::slots_of(a.bvh), slots_b = space::slots_of(b.bvh);
  space::require_pairs(pairs, slots_a.size(), slots_b.size());
  std::vector<Intersection3> common(pairs.size());
  constexpr std::size_t part_size = 16;
  const std::size_t parts = space::blocks_of(pairs.size(), part_size);
  space::for_parts("intersections", options.execution, options.progress, parts, [&](std::size_t part) {
    const std::size_t to = std::min(pairs.size(), (part + 1) * part_size);
    for (std::size_t i = part * part_size; i < to; ++i)
      common[i] = query::intersection(a.triangle(slots_a[pairs[i].a]), b.triangle(slots_b[pairs[i].b]));
  });
  return common;
}

}  // namespace plumb
