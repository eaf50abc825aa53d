#include "plumb/surface/topology/shells.hpp"

#include <algorithm>
#include <atomic>

#include "figure/basic/lists_by_number.hpp"
#include "plumb/predicates.hpp"
#include "space/bvh/slot_triangles.hpp"
#include "space/pairs/pair_search.hpp"
#include "surface/topology/disjoint_sets.hpp"
#include "surface/topology/internal_walls.hpp"
#include "surface/topology/mesh_corner.hpp"
#include "surface/topology/shell_nesting.hpp"
#include "surface/topology/signed_volume.hpp"

namespace plumb {
namespace {

/// The components of the triangles over edges of two.
Shells components(const TriangleMesh& mesh, const MeshEdges& edges) {
  const auto n = static_cast<std::uint32_t>(mesh.triangles.size());
  surface::DisjointSets sets(n);
  for (std::size_t e = 0; e < edges.edges.size(); ++e)
    if (const auto uses = edges.uses_of(e); uses.size() == 2) sets.unite(uses[0].face, uses[1].face);
  Shells found;
  found.shell_of.resize(n, no_shell);
  for (std::uint32_t t = 0; t < n; ++t) {
    if (surface::names_a_vertex_twice(mesh.triangles[t])) continue;
    const std::uint32_t first = sets.find(t);
    if (first == t) {
      found.shell_of[t] = static_cast<std::uint32_t>(found.shells.size());
      found.shells.push_back({.first_triangle = t, .closed = true, .oriented = true});
    }
    found.shell_of[t] = found.shell_of[first];
    ++found.shells[found.shell_of[t]].triangles;
  }
  return found;
}

/// Looks at the edges of each shell for itself.
void judge_edges(const MeshEdges& edges, Shells& found) {
  struct Run {
    std::uint32_t shell;
    int forward, backward;
  };
  std::vector<Run> runs;
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    runs.clear();
    for (const EdgeUse& use : edges.uses_of(e)) {
      const std::uint32_t shell = found.shell_of[use.face];
      auto run = std::ranges::find(runs, shell, &Run::shell);
      if (run == runs.end()) run = runs.insert(runs.end(), {shell, 0, 0});
      ++(use.forward ? run->forward : run->backward);
    }
    for (const Run& run : runs) {
      Shell& s = found.shells[run.shell];
      if ((run.forward + run.backward) % 2 != 0) s.closed = false;
      if (std::abs(run.forward - run.backward) > 1) s.oriented = false;
    }
  }
}

void measure(const TriangleMesh& mesh, Shells& found) {
  const figure::ListsByNumber triangles(found.shell_of, found.shells.size());
  const auto as_it_is = [](std::uint32_t t) { return surface::SidedTriangle{t, false}; };
  for (std::size_t i = 0; i < found.shells.size(); ++i) {
    Shell& s = found.shells[i];
    if (!s.closed || !s.oriented) continue;
    s.volume = arith::exact_sum::nearest(surface::volume_sum(mesh, triangles[i], as_it_is), 6);
    s.volume_sign = *s.volume != 0 ? sign_of_number(*s.volume) : surface::sign_of_volume(mesh, triangles[i], as_it_is);
  }
}

bool are_coplanar(const Triangle3& s, const Triangle3& t) {
  const auto in_plane = [](const Triangle3& plane, const Triangle3& of) {
    return std::ranges::all_of(std::array{of.a, of.b, of.c},
                               [&](const Point3& p) { return orient3d(plane.a, plane.b, plane.c, p) == Sign::zero; });
  };
  return in_plane(s, t) && in_plane(t, s);
}

/// What pairs of triangles tell of shells, from several threads.
class MetShells {
 public:
  explicit MetShells(Shells& found)
      : found_(found), meets_(found.shells.size()), crosses_(found.shells.size()), at_others_(found.shell_of.size()) {}

  void begin(std::size_t parts) { parts_.resize(parts); }
  void take(std::size_t part, const TrianglePair& pair, const Triangle3& a, const Triangle3& b) {
    Part& p = parts_[part];
    ++(pair.relation == Relation::touching ? p.met.touching : p.met.overlapping);
    const std::uint32_t s = found_.shell_of[pair.a], t = found_.shell_of[pair.b];
    if (s == t || s == no_shell || t == no_shell) return;
    mark(meets_[s]), mark(meets_[t]);
    mark(at_others_[pair.a]), mark(at_others_[pair.b]);
    if (pair.relation == Relation::touching || are_coplanar(a, b)) return;
    mark(crosses_[s]), mark(crosses_[t]);
    if (!found_.shells[s].closed && !found_.shells[t].closed) return;
    p.crossing.push_back(std::minmax(s, t));
    if (p.crossing.size() < p.most) return;
    sort_once(p.crossing);
    p.most = std::max(p.most, 2 * p.crossing.size());
  }
  /// Shells that share a vertex, which triangles do not tell.
  void take_shared_vertices(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> shell_at(mesh.vertices.size(), no_shell);
    std::vector<bool> several(mesh.vertices.size());
    for_each_corner(mesh, [&](std::uint32_t, std::uint32_t shell, std::uint32_t v) {
      if (shell_at[v] == no_shell) shell_at[v] = shell;
      if (shell_at[v] != shell) several[v] = true;
    });
    for_each_corner(mesh, [&](std::uint32_t t, std::uint32_t shell, std::uint32_t v) {
      if (several[v]) mark(meets_[shell]), mark(at_others_[t]);
    });
  }
  /// Writes it all down; says of each triangle whether it meets another shell.
  std::vector<std::uint8_t> finish() {
    for (const Part& p : parts_) {
      found_.met.touching += p.met.touching;
      found_.met.overlapping += p.met.overlapping;
      found_.crossing.insert(found_.crossing.end(), p.crossing.begin(), p.crossing.end());
    }
    sort_once(found_.crossing);
    for (std::size_t s = 0; s < found_.shells.size(); ++s) {
      found_.shells[s].meets = meets_[s] != 0;
      found_.shells[s].crosses = crosses_[s] != 0;
    }
    return std::move(at_others_);
  }

 private:
  struct Part {
    PairCount met;
    std::vector<ShellPair> crossing;
    std::size_t most = 4096;  // before they are sorted, and each is kept once
  };
  static void sort_once(std::vector<ShellPair>& pairs) {
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  }
  static void mark(std::uint8_t& flag) {
    const std::atomic_ref shared(flag);
    if (shared.load(std::memory_order_relaxed) == 0) shared.store(1, std::memory_order_relaxed);
  }
  template <class Visit>
  void for_each_corner(const TriangleMesh& mesh, const Visit& visit) const {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      if (found_.shell_of[t] == no_shell) continue;
      for (const std::uint32_t v : mesh.triangles[t]) visit(t, found_.shell_of[t], v);
    }
  }

  Shells& found_;
  std::vector<std::uint8_t> meets_, crosses_, at_others_;
  std::vector<Part> parts_;
};

void take_pairs(const Bvh& bvh, const ShellOptions& options, MetShells& met) {
  const PairOptions asked{.execution = options.execution, .progress = options.progress};
  if (space::is_split(bvh)) {  // a pair may be found several times
    const std::vector<std::uint32_t> slots = space::slots_of(bvh);
    met.begin(1);
    for (const TrianglePair& pair : intersecting_pairs(bvh, asked))
      met.take(0, pair, bvh.triangle(slots[pair.a]), bvh.triangle(slots[pair.b]));
    return;
  }
  const space::PairSearch search("find_shells", bvh, bvh, true, asked);
  search.run(
      options.execution, [&](std::size_t parts) { met.begin(parts); },
      [&](std::size_t part, const TrianglePair& pair, space::SlotPair slots) {
        met.take(part, pair, bvh.triangle(slots.a), bvh.triangle(slots.b));
        return Descent::go_on;
      });
}

}  // namespace

Shells find_shells(const TriangleMesh& mesh, const MeshEdges& edges, const Bvh& bvh, const ShellOptions& options) {
  Shells found = components(mesh, edges);
  judge_edges(edges, found);
  measure(mesh, found);
  MetShells met(found);
  take_pairs(bvh, options, met);
  met.take_shared_vertices(mesh);
  surface::nest_shells(bvh, mesh, met.finish(), options.execution, found);
  surface::find_dividing_walls(mesh, edges, found);
  for (Shell& s : found.shells) s.wall = s.wall || (!s.closed && s.depth % 2 == 1);
  return found;
}

Shells find_shells(const TriangleMesh& mesh, const ShellOptions& options) {
  const Bvh bvh = build_bvh(mesh, {.execution = options.execution});
  return find_shells(mesh, find_edges(mesh), bvh, options);
}

}  // namespace plumb
