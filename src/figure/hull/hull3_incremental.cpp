// Randomized incremental construction with a conflict graph: which nodes are above which faces, all of them.
//
// A new face joins the horizon's edge with the apex, so what is above it was above one of the two faces at that edge:
// its plane's normal is a combination of theirs with factors that are not negative.
#include "arith/splitmix.hpp"
#include "figure/hull/hull3_methods.hpp"

namespace plumb::figure::hull3 {
namespace {

/// Always the same way: each place is swapped with one up to it, by the numbers of splitmix64.
void shuffle(std::vector<Id>& order) {
  std::uint64_t state = 0;
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[splitmix64(state) % i]);
}

class ConflictGraph {
 public:
  ConflictGraph(Surface& surface, bool keep_flat)
      : surface_(surface), keep_flat_(keep_flat), of_node_(surface.nodes().size(), none), tried_(of_node_.size(), 0) {}

  void run(const std::array<Id, 4>& simplex) {
    surface_.start(simplex);
    const std::array<Id, 4> faces{0, 1, 2, 3};
    of_face_.assign(4, none);
    auto& nodes = surface_.nodes();
    std::vector<Id> order;
    for (Id q = 0; q < nodes.size(); ++q) {
      if (std::ranges::find(simplex, q) != simplex.end()) continue;
      order.push_back(q);
      for (const Id face : faces) {
        if (surface_.side(face, nodes[q].point) < 0) add(q, face);
      }
      if (of_node_[q] != none) continue;
      const auto equal = std::ranges::find(simplex, nodes[q].point, [&](Id v) { return nodes[v].point; });
      if (equal != simplex.end()) {
        take_index(nodes[*equal], nodes[q]);
      } else if (keep_flat_) {
        keep_if_flat(surface_, faces, q);
      }
    }
    shuffle(order);
    for (const Id q : order) {
      if (of_node_[q] != none) insert(q);
    }
  }

 private:
  struct Arc {
    Id node, face, next_of_face, next_of_node, before_of_node;
  };

  void add(Id node, Id face) {
    Id id = static_cast<Id>(arcs_.size());
    if (free_ != none) {
      id = free_;
      free_ = arcs_[id].next_of_face;
    } else {
      arcs_.emplace_back();
    }
    arcs_[id] = {node, face, of_face_[face], of_node_[node], none};
    if (of_node_[node] != none) arcs_[of_node_[node]].before_of_node = id;
    of_face_[face] = of_node_[node] = id;
  }

  /// Forgets what is above the face.
  void drop(Id face) {
    for (Id id = of_face_[face]; id != none;) {
      const Arc arc = arcs_[id];
      (arc.before_of_node == none ? of_node_[arc.node] : arcs_[arc.before_of_node].next_of_node) = arc.next_of_node;
      if (arc.next_of_node != none) arcs_[arc.next_of_node].before_of_node = arc.before_of_node;
      arcs_[id].next_of_face = free_;
      free_ = id;
      id = arc.next_of_face;
    }
    of_face_[face] = none;
  }

  void insert(Id apex) {
    seen_by_.resize(surface_.faces().size(), none);
    for (Id id = of_node_[apex]; id != none; id = arcs_[id].next_of_node) seen_by_[arcs_[id].face] = apex;
    surface_.walk(arcs_[of_node_[apex]].face, [&](Id face) { return seen_by_[face] == apex; });
    collect_equal(apex);
    horizon_.clear();
    for (const Id behind : surface_.horizon()) horizon_.push_back({surface_.twin(behind) / 3, behind / 3});
    const std::span<const Id> cone = surface_.cone(apex);
    of_face_.resize(surface_.faces().size(), none);
    for (std::size_t i = 0; i < cone.size(); ++i) {
      ++stamp_;
      tried_[apex] = stamp_;
      for (const Id from : horizon_[i]) inherit(from, cone[i]);
    }
    release(cone);
    surface_.drop_visible();
  }

  /// Equal points are above the same faces.
  void collect_equal(Id apex) {
    auto& nodes = surface_.nodes();
    equal_.clear();
    for (Id id = of_face_[surface_.visible().front()]; id != none; id = arcs_[id].next_of_face) {
      const Id q = arcs_[id].node;
      if (q == apex || nodes[q].point != nodes[apex].point) continue;
      take_index(nodes[apex], nodes[q]);
      equal_.push_back(q);
    }
  }

  void inherit(Id from, Id face) {
    for (Id id = of_face_[from]; id != none;) {
      const Id q = arcs_[id].node, next = arcs_[id].next_of_face;
      if (tried_[q] != stamp_) {
        tried_[q] = stamp_;
        if (surface_.side(face, surface_.point(q)) < 0) add(q, face);
      }
      id = next;
    }
  }

  /// The nodes of the visible faces lose them; those that are above no face any more may lie on the cone.
  void release(std::span<const Id> cone) {
    lost_.clear();
    for (const Id face : surface_.visible()) {
      for (Id id = of_face_[face]; keep_flat_ && id != none; id = arcs_[id].next_of_face) {
        lost_.push_back(arcs_[id].node);
      }
      drop(face);
    }
    if (!keep_flat_) return;
    std::ranges::sort(lost_);
    lost_.erase(std::unique(lost_.begin(), lost_.end()), lost_.end());
    const Id apex = surface_.faces()[cone.front()].vertex[2];
    for (const Id q : lost_) {
      if (q != apex && of_node_[q] == none && std::ranges::find(equal_, q) == equal_.end()) {
        keep_if_flat(surface_, cone, q);
      }
    }
    hand_on_flat(surface_, cone);
  }

  Surface& surface_;
  bool keep_flat_;
  std::vector<Arc> arcs_;
  Id free_ = none;
  std::vector<Id> of_face_, of_node_, tried_, seen_by_, equal_, lost_;
  std::vector<std::array<Id, 2>> horizon_;  // the vanishing face and the one behind it
  Id stamp_ = 0;
};

}  // namespace

void grow_incrementally(Surface& surface, const std::array<Id, 4>& simplex, bool keep_flat) {
  ConflictGraph(surface, keep_flat).run(simplex);
}

}  // namespace plumb::figure::hull3
