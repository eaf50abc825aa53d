// As in mesh_pairs.cpp: pairs of nodes down to some hundred parts, each down to its leaves, all pairs in order.
#include "plumb/space/pairs/volume_pairs.hpp"

#include "plumb/query/overlap/overlap.hpp"
#include "plumb/space/bvh/descend_pairs.hpp"
#include "query/overlap/posed_triangles.hpp"
#include "space/bvh/pair_parts.hpp"
#include "space/bvh/parts.hpp"
#include "space/bvh/posed_box.hpp"
#include "space/bvh/slot_boxes.hpp"
#include "space/pairs/pair_answers.hpp"

namespace plumb {
namespace space {
namespace {

constexpr std::size_t volume_parts_wanted = 512;

/// Triangles of one mesh in the slots of a leaf, each with its box.
class BoxedLeaf {
 public:
  explicit BoxedLeaf(const PosedMesh& mesh) : mesh_(mesh), stands_(mesh.pose == identity_pose) {}

  [[nodiscard]] bool stands() const { return stands_; }

  void read(std::uint32_t first, std::uint32_t count) {
    first_ = first;
    boxes_.clear();
    for (std::uint32_t s = first; s < first + count; ++s) {
      boxes_.push_back(stands_ ? box_around(mesh_.bvh.triangles[s], mesh_.bvh.vertices.view())
                               : around(mesh_.triangle(s)));
    }
  }
  [[nodiscard]] std::size_t size() const { return boxes_.size(); }
  [[nodiscard]] const Aabb3& box(std::size_t i) const { return boxes_[i]; }
  [[nodiscard]] std::uint32_t slot(std::size_t i) const { return first_ + static_cast<std::uint32_t>(i); }
  [[nodiscard]] std::uint32_t item(std::size_t i) const { return mesh_.bvh.tree.items[slot(i)]; }
  [[nodiscard]] PosedTriangle triangle(std::size_t i) const { return mesh_.triangle(first_ + i); }

 private:
  const PosedMesh& mesh_;
  bool stands_;
  std::uint32_t first_ = 0;
  std::vector<Aabb3> boxes_;
};

/// take(TrianglePair, SlotPair) of each pair of two leaves that meets; it may say Descent::stop.
class VolumeLeaves {
 public:
  VolumeLeaves(const PosedMesh& a, const PosedMesh& b) : a_(a), b_(b) {}

  template <class Node, class Take>
  Descent operator()(const Node& leaf_a, const Node& leaf_b, const Take& take) {
    a_.read(leaf_a.link, leaf_a.count);
    b_.read(leaf_b.link, leaf_b.count);
    for (std::size_t i = 0; i < a_.size(); ++i) {
      for (std::size_t k = 0; k < b_.size(); ++k) {
        if (!boxes_meet(a_.box(i), b_.box(k))) continue;
        const Relation relation = a_.stands() && b_.stands() ? relate(a_.triangle(i).shape, b_.triangle(k).shape)
                                                             : query::relate(a_.triangle(i), b_.triangle(k));
        if (relation == Relation::disjoint) continue;
        const TrianglePair pair{a_.item(i), b_.item(k), relation};
        if (take(pair, SlotPair{a_.slot(i), b_.slot(k)}) == Descent::stop) return Descent::stop;
      }
    }
    return Descent::go_on;
  }

 private:
  BoxedLeaf a_, b_;
};

template <class Volume>
class VolumePairSearch {
 public:
  VolumePairSearch(const char* function, const VolumeMesh<Volume>& a, const VolumeMesh<Volume>& b,
                   const PairOptions& options)
      : function_(function), a_(a), b_(b), options_(options) {
    require_pose(function, "a", a.mesh.pose);
    require_pose(function, "b", b.mesh.pose);
    require_tree_of(function, "a.volumes", a.mesh.bvh, a.volumes);
    require_tree_of(function, "b.volumes", b.mesh.bvh, b.volumes);
  }

  template <class Begin, class Take>
  void run(Execution execution, const Begin& begin, const Take& take, std::size_t wanted = volume_parts_wanted) const {
    using Node = VolumeNode<Volume>;
    const std::span<const Node> as = a_.volumes.nodes.view(), bs = b_.volumes.nodes.view();
    const auto down = [&](NodePair pair, const auto& next) { replace_pair(as, bs, descend_larger{}, pair, next); };
    const volumes_meet meet;
    const std::vector<NodePair> all = pair_parts(as, bs, wanted, down, meet);
    begin(all.size());
    for_parts(function_, execution, options_.progress, all.size(), [&](std::size_t part) {
      VolumeLeaves leaves(a_.mesh, b_.mesh);
      const auto visit = [&](const Node& leaf_a, const Node& leaf_b) {
        return leaves(leaf_a, leaf_b, [&](const TrianglePair& pair, SlotPair slots) {
          return pair.relation == Relation::touching && !options_.touching ? Descent::go_on : take(part, pair, slots);
        });
      };
      return descend_from(as, bs, all[part], down, meet, visit);
    });
  }

 private:
  const char* function_;
  const VolumeMesh<Volume>&a_, &b_;
  const PairOptions& options_;
};

template <class Volume>
PairWork counted_work(const VolumeMesh<Volume>& a, const VolumeMesh<Volume>& b) {
  constexpr const char* function = "pair_work";
  require_pose(function, "a", a.mesh.pose);
  require_pose(function, "b", b.mesh.pose);
  require_tree_of(function, "a.volumes", a.mesh.bvh, a.volumes);
  require_tree_of(function, "b.volumes", b.mesh.bvh, b.volumes);
  PairWork work;
  VolumeLeaves leaves(a.mesh, b.mesh);
  using Node = VolumeNode<Volume>;
  descend_pairs(
      a.volumes, b.volumes, descend_larger{},
      [&](const Node& x, const Node& y) {
        ++work.volume_tests;
        return volumes_meet{}(x, y);
      },
      [&](const Node& x, const Node& y) {
        ++work.leaf_pairs;
        work.triangle_pairs += std::size_t{x.count} * y.count;
        leaves(x, y, [&](const TrianglePair&, SlotPair) {
          ++work.pairs;
          return Descent::go_on;
        });
      });
  return work;
}

}  // namespace
}  // namespace space

template <class Volume>
std::vector<TrianglePair> intersecting_pairs(const VolumeMesh<Volume>& a, const VolumeMesh<Volume>& b,
                                             const PairOptions& options, std::vector<TrianglePair> rows) {
  return space::all_pairs(space::VolumePairSearch("intersecting_pairs", a, b, options), a.mesh.bvh.triangles.size(),
                          options.execution, std::move(rows));
}

template <class Volume>
std::optional<TrianglePair> any_intersecting_pair(const VolumeMesh<Volume>& a, const VolumeMesh<Volume>& b,
                                                  const PairOptions& options) {
  return space::any_pair(space::VolumePairSearch("any_intersecting_pair", a, b, options));
}

template <class Volume>
PairWork pair_work(const VolumeMesh<Volume>& a, const VolumeMesh<Volume>& b) {
  return space::counted_work(a, b);
}

#define PLUMB_PAIRS_OF(Volume)                                                                                     \
  template std::vector<TrianglePair> intersecting_pairs(const VolumeMesh<Volume>&, const VolumeMesh<Volume>&,      \
                                                        const PairOptions&, std::vector<TrianglePair>);            \
  template std::optional<TrianglePair> any_intersecting_pair(const VolumeMesh<Volume>&, const VolumeMesh<Volume>&, \
                                                             const PairOptions&);                                  \
  template PairWork pair_work(const VolumeMesh<Volume>&, const VolumeMesh<Volume>&);
PLUMB_PAIRS_OF(Sphere3)
PLUMB_PAIRS_OF(Aabb3)
PLUMB_PAIRS_OF(Obb3)
PLUMB_PAIRS_OF(KDop3)
#undef PLUMB_PAIRS_OF

}  // namespace plumb
