// Quickhull: each face lists nodes that are above it, a node being in one list at most.
//
// After a cone it suffices to test the nodes of the vanished faces against the new ones: the segment from an inner
// point of a vanished face to a node above it leaves the grown hull through a new face, if at all.
#include "figure/hull/hull3_methods.hpp"

namespace plumb::figure::hull3 {
namespace {

class Quickhull {
 public:
  Quickhull(Surface& surface, bool keep_flat) : surface_(surface), keep_flat_(keep_flat) {}

  void run(const std::array<Id, 4>& simplex) {
    surface_.start(simplex);
    const std::array<Id, 4> faces{0, 1, 2, 3};
    use(faces);
    auto& nodes = surface_.nodes();
    for (Id q = 0; q < nodes.size(); ++q) {
      if (std::ranges::find(simplex, q) != simplex.end() || assign(q)) continue;
      const auto equal = std::ranges::find(simplex, nodes[q].point, [&](Id v) { return nodes[v].point; });
      equal == simplex.end() ? keep(q) : take_index(nodes[*equal], nodes[q]);
    }
    list_pending();
    while (!pending_.empty()) {  // ends, for each node becomes a vertex once at most
      const Id face = pending_.back();
      pending_.pop_back();
      if (surface_.faces()[face].alive() && surface_.faces()[face].list != none) add_farthest(face);
    }
  }

 private:
  struct Candidate {
    FacePlane plane;
    Id face, list, farthest;
    double height;
  };

  /// The faces to which nodes are assigned now, side by side in memory.
  void use(std::span<const Id> faces) {
    candidates_.clear();
    for (const Id f : faces) candidates_.push_back({surface_.plane(f), f, none, none, 0});
  }

  void list_pending() {
    for (const Candidate& c : candidates_) {
      if (c.list == none) continue;
      Face& face = surface_.faces()[c.face];
      face.list = c.list;
      face.farthest = c.farthest;
      pending_.push_back(c.face);
    }
  }

  /// To the first face that the node is above.
  bool assign(Id q) {
    Node& node = surface_.nodes()[q];
    const Point3 p = node.point;
    for (Candidate& c : candidates_) {
      const double value = c.plane.value(p), bound = c.plane.bound;
      if (value > bound) continue;
      if (!(value < -bound) && surface_.exact_side(c.face, p) >= 0) continue;
      node.next = c.list;
      c.list = q;
      if (c.farthest == none || -value > c.height) {
        c.farthest = q;
        c.height = -value;
      }
      return true;
    }
    return false;
  }

  void keep(Id q) {
    if (!keep_flat_) return;
    faces_.clear();
    for (const Candidate& c : candidates_) faces_.push_back(c.face);
    keep_if_flat(surface_, faces_, q);
  }

  void add_farthest(Id from) {
    const Id apex = surface_.faces()[from].farthest;
    surface_.look(from, surface_.point(apex));
    const std::span<const Id> cone = surface_.cone(apex);
    use(cone);
    auto& nodes = surface_.nodes();
    for (const Id seen : surface_.visible()) {
      for (Id q = surface_.faces()[seen].list; q != none;) {
        const Id next = nodes[q].next;
        if (q != apex && !assign(q)) {
          nodes[q].point == nodes[apex].point ? take_index(nodes[apex], nodes[q]) : keep(q);
        }
        q = next;
      }
    }
    if (keep_flat_) hand_on_flat(surface_, cone);
    list_pending();
    surface_.drop_visible();
  }

  Surface& surface_;
  bool keep_flat_;
  std::vector<Candidate> candidates_;
  std::vector<Id> pending_, faces_;
};

}  // namespace

void grow_quickhull(Surface& surface, const std::array<Id, 4>& simplex, bool keep_flat) {
  Quickhull(surface, keep_flat).run(simplex);
}

}  // namespace plumb::figure::hull3
