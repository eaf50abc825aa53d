// Under one regular pose the question without it; else pairs of posed boxes down to leaves, as in mesh_pairs.cpp.
#include "plumb/space/pairs/posed_pairs.hpp"

#include <algorithm>

#include "plumb/predicates.hpp"
#include "plumb/space/bvh/descend_pairs.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/pairs/pair_order.hpp"
#include "space/pairs/posed_neighbors.hpp"

namespace plumb {
namespace space {
namespace {

constexpr std::size_t posed_parts_wanted = 512;

bool posed_boxes_meet(const Aabb3& a, const Aabb3& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
         b.min.z <= a.max.z;
}

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
    const std::vector<NodePair> all = parts();
    begin(all.size());
    for_parts(function_, execution, options_.progress, all.size(), [&](std::size_t part) {
      const auto visit = [&](const BoxNode& leaf_a, const BoxNode& leaf_b) {
        return on_leaves(leaf_a, leaf_b, [&](const TrianglePair& pair) {
          return pair.relation == Relation::touching && !options_.touching ? Descent::go_on : take(part, pair);
        });
      };
      const auto down = [&](NodePair pair, const auto& next) { replace(pair, next); };
      const auto meet = [&](const BoxNode& a, const BoxNode& b) { return posed_boxes_meet(box_a(a), box_b(b)); };
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

  [[nodiscard]] std::vector<NodePair> parts() const {
    const auto meet = [&](NodePair p) { return posed_boxes_meet(box_a(nodes_a_[p.a]), box_b(nodes_b_[p.b])); };
    std::vector<NodePair> now, next;
    if (meet({0, 0})) now.push_back({0, 0});
    for (bool any = true; any && now.size() < posed_parts_wanted; now.swap(next)) {
      any = false;
      next.clear();
      for (const NodePair pair : now) {
        if (nodes_a_[pair.a].is_leaf() && nodes_b_[pair.b].is_leaf()) {
          next.push_back(pair);
          continue;
        }
        any = true;
        replace(pair, [&](NodePair p) {
          if (meet(p)) next.push_back(p);
        });
      }
    }
    return now;
  }

  /// Those of a leaf whose boxes meet that of the other leaf.
  static std::vector<PosedSlot> slots(const PosedMesh& mesh, const BoxNode& leaf, const Aabb3& other) {
    std::vector<PosedSlot> all;
    for (std::uint32_t s = leaf.link; s < leaf.link + leaf.count; ++s) {
      const Aabb3 box = around(mesh.triangle(s));
      if (posed_boxes_meet(box, other)) all.push_back({s, box});
    }
    return all;
  }

  template <class Take>
  Descent on_leaves(const BoxNode& leaf_a, const BoxNode& leaf_b, const Take& take) const {
    const std::vector<PosedSlot> slots_a = slots(a_, leaf_a, box_b(leaf_b));
    if (slots_a.empty()) return Descent::go_on;
    const std::vector<PosedSlot> slots_b = slots(b_, leaf_b, box_a(leaf_a));
    for (const PosedSlot& p : slots_a) {
      for (const PosedSlot& q : slots_b) {
        if (own_ && leaf_a.link == leaf_b.link && q.slot <= p.slot) continue;
        if (!posed_boxes_meet(p.box, q.box)) continue;
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

std::vector<TrianglePair> all_posed_pairs(const char* function, const PosedMesh& a, const PosedMesh& b, bool own,
                                          const PairOptions& options) {
  std::vector<std::vector<TrianglePair>> found;
  PosedPairSearch(function, a, b, own, options)
      .run(
          options.execution, [&](std::size_t parts) { found.resize(parts); },
          [&](std::size_t part, const TrianglePair& pair) {
            found[part].push_back(pair);
            return Descent::go_on;
          });
  std::vector<TrianglePair> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  sort_pairs(all, a.bvh.triangles.size());
  return all;
}

PairCount counted_posed_pairs(const char* function, const PosedMesh& a, const PosedMesh& b, bool own,
                              const PairOptions& options) {
  std::vector<PairCount> found;
  PosedPairSearch(function, a, b, own, options)
      .run(
          options.execution, [&](std::size_t parts) { found.resize(parts); },
          [&](std::size_t part, const TrianglePair& pair) {
            ++(pair.relation == Relation::touching ? found[part].touching : found[part].overlapping);
            return Descent::go_on;
          });
  PairCount all;
  for (const PairCount& part : found) all.touching += part.touching, all.overlapping += part.overlapping;
  return all;
}

std::optional<TrianglePair> any_posed_pair(const char* function, const PosedMesh& a, const PosedMesh& b, bool own,
                                           const PairOptions& options) {
  std::optional<TrianglePair> found;
  PosedPairSearch(function, a, b, own, options)
      .run(
          Execution::serial, [](std::size_t) {},
          [&](std::size_t, const TrianglePair& pair) {
            found = pair;
            return Descent::stop;
          });
  return found;
}

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
  return space::are_moved_alike(function, a, b) ? intersecting_pairs(a.bvh, b.bvh, options)
                                                : space::all_posed_pairs(function, a, b, false, options);
}
std::vector<TrianglePair> self_intersecting_pairs(const PosedMesh& mesh, const PairOptions& options) {
  constexpr const char* function = "self_intersecting_pairs";
  return space::is_moved_regularly(function, mesh) ? self_intersecting_pairs(mesh.bvh, options)
                                                   : space::all_posed_pairs(function, mesh, mesh, true, options);
}

PairCount count_intersecting_pairs(const PosedMesh& a, const PosedMesh& b, const PairOptions& options) {
  constexpr const char* function = "count_intersecting_pairs";
  return space::are_moved_alike(function, a, b) ? count_intersecting_pairs(a.bvh, b.bvh, options)
                                                : space::counted_posed_pairs(function, a, b, false, options);
}
PairCount count_self_intersecting_pairs(const PosedMesh& mesh, const PairOptions& options) {
  constexpr const char* function = "count_self_intersecting_pairs";
  return space::is_moved_regularly(function, mesh) ? count_self_intersecting_pairs(mesh.bvh, options)
                                                   : space::counted_posed_pairs(function, mesh, mesh, true, options);
}

std::optional<TrianglePair> any_intersecting_pair(const PosedMesh& a, const PosedMesh& b, const PairOptions& options) {
  constexpr const char* function = "any_intersecting_pair";
  return space::are_moved_alike(function, a, b) ? any_intersecting_pair(a.bvh, b.bvh, options)
                                                : space::any_posed_pair(function, a, b, false, options);
}
std::optional<TrianglePair> any_self_intersecting_pair(const PosedMesh& mesh, const PairOptions& options) {
  constexpr const char* function = "any_self_intersecting_pair";
  return space::is_moved_regularly(function, mesh) ? any_self_intersecting_pair(mesh.bvh, options)
                                                   : space::any_posed_pair(function, mesh, mesh, true, options);
}

}  // namespace plumb
