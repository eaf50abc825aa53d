// Boundary loops, filled where the filling meets nothing.
#include <algorithm>
#include <map>

#include "plumb/space/pairs/mesh_pairs.hpp"
#include "plumb/space/pairs/neighbors.hpp"
#include "plumb/surface/topology/components.hpp"
#include "surface/repair/island_filling.hpp"
#include "surface/repair/least_area.hpp"
#include "surface/repair/loop_filling.hpp"
#include "surface/repair/point_order.hpp"
#include "surface/repair/steps.hpp"
#include "surface/topology/windings.hpp"

namespace plumb::surface {
namespace {

constexpr std::size_t most_for_least_area = 256;

struct Hole {
  std::vector<std::uint32_t> loop;  // as the filling runs along it, from its first point on
  Filling filling{};
  bool filled = false, clashes = false;
  bool tied = false;  // by fillings of exactly the least area
  std::vector<std::uint32_t>
      islands{};  // further loops of what is filled, numbers of holes that have no filling of their own
};

/// Loops that pass no vertex twice: of one that does the parts between are cut off.
std::vector<std::vector<std::uint32_t>> simple_loops(const std::vector<std::uint32_t>& loop) {
  std::vector<std::vector<std::uint32_t>> simple;
  std::vector<std::uint32_t> path;
  for (const std::uint32_t v : loop) {
    const auto again = std::ranges::find(path, v);
    if (again != path.end()) {
      simple.emplace_back(again, path.end());
      path.erase(again, path.end());
    }
    path.push_back(v);
  }
  simple.push_back(std::move(path));
  return simple;
}

/// Of the edge between two vertices; empty where there is none.
std::span<const EdgeUse> uses_between(const MeshEdges& edges, std::uint32_t a, std::uint32_t b) {
  const std::array edge{std::min(a, b), std::max(a, b)};
  const auto at = std::ranges::lower_bound(edges.edges, edge);
  if (at == edges.edges.end() || *at != edge) return {};
  return edges.uses_of(static_cast<std::size_t>(at - edges.edges.begin()));
}

/// The loop against the way in which most of its triangles run along it; where half of them do, the way that begins
/// with what comes first.
std::vector<std::uint32_t> turned_against(const TriangleMesh& mesh, const MeshEdges& edges,
                                          std::vector<std::uint32_t> loop) {
  std::size_t alike = 0;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t a = loop[i], b = loop[(i + 1) % n];
    alike += uses_between(edges, a, b)[0].forward == (a < b);
  }
  begin_with_first(mesh.vertices, loop);
  std::vector<std::uint32_t> reversed(loop.rbegin(), loop.rend());
  begin_with_first(mesh.vertices, reversed);
  const auto before = [&](std::uint32_t l, std::uint32_t r) {
    return comes_before(mesh.vertices[l], mesh.vertices[r]);
  };
  const bool stays = 2 * alike != n ? 2 * alike < n : std::ranges::lexicographical_compare(loop, reversed, before);
  return stays ? loop : reversed;
}

std::vector<Hole> holes_of(RepairWork& work, const MeshEdges& edges) {
  const Windings windings = find_windings(work.mesh, edges);
  std::vector<Hole> holes;
  for (const BoundaryLoop& boundary : boundary_loops(work.mesh, edges)) {
    const auto& v = boundary.vertices;
    if (!boundary.closed) {
      work.note_hole(ChangeKind::open_chain, v, v.size() - 1);
    } else if (windings.orientable[windings.components.of[uses_between(edges, v.back(), v.front())[0].face]] == 0) {
      work.note_hole(ChangeKind::one_sided_hole, v, v.size());
    } else {
      for (std::vector<std::uint32_t>& loop : simple_loops(turned_against(work.mesh, edges, v))) {
        begin_with_first(work.mesh.vertices, loop);
        holes.push_back({std::move(loop)});
      }
    }
  }
  return holes;
}

/// A mesh of some holes' fillings, on vertices of its own.
struct Fillings {
  TriangleMesh mesh;
  std::vector<std::uint32_t> hole, vertex;  // of each triangle; of each vertex its number in the mesh that is mended

  Fillings(const TriangleMesh& of, const std::vector<Hole>& holes) {
    for (const Hole& h : holes) vertex.insert(vertex.end(), h.loop.begin(), h.loop.end());
    std::ranges::sort(vertex);
    vertex.erase(std::unique(vertex.begin(), vertex.end()), vertex.end());
    for (const std::uint32_t v : vertex) mesh.vertices.push_back(of.vertices[v]);
    for (std::uint32_t i = 0; i < holes.size(); ++i) {
      for (const auto& [a, b, c] : holes[i].filling) {
        mesh.triangles.push_back({own(a), own(b), own(c)});
        hole.push_back(i);
      }
    }
  }
  [[nodiscard]] std::uint32_t own(std::uint32_t v) const {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(vertex, v) - vertex.begin());
  }
  [[nodiscard]] TriangleMesh::Triangle triangle(std::uint32_t t) const {
    const auto& [a, b, c] = mesh.triangles[t];
    return {vertex[a], vertex[b], vertex[c]};
  }
};

/// Marks the holes whose fillings meet the surface or one another beyond shared vertices, or share a diagonal.
void find_clashes(const TriangleMesh& mesh, const Bvh& surface, Execution execution, std::vector<Hole>& holes) {
  const Fillings fillings(mesh, holes);
  if (fillings.mesh.triangles.empty()) return;
  const Bvh bvh = build_bvh(fillings.mesh, {.execution = execution});
  const PairOptions asked{.execution = execution};
  for (const TrianglePair& p : intersecting_pairs(surface, bvh, asked)) {
    Hole& hole = holes[fillings.hole[p.b]];
    if (!hole.clashes &&
        relate_in_mesh(mesh.vertices, mesh.triangles[p.a], fillings.triangle(p.b)) != Relation::disjoint)
      hole.clashes = true;
  }
  for (const TrianglePair& p : intersecting_pairs(bvh, asked))
    holes[fillings.hole[p.a]].clashes = holes[fillings.hole[p.b]].clashes = true;
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> hole_of;  // of each edge of a filling
  for (std::uint32_t t = 0; t < fillings.mesh.triangles.size(); ++t) {
    const auto corners = fillings.triangle(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = corners[k], b = corners[(k + 1) % 3], hole = fillings.hole[t];
      const auto [at, is_new] = hole_of.insert({{std::min(a, b), std::max(a, b)}, hole});
      if (!is_new && at->second != hole) holes[hole].clashes = holes[at->second].clashes = true;
    }
  }
}

/// Is an edge within the filling one that is taken?
bool has_taken_diagonal(const Filling& filling, const TakenDiagonal& is_taken) {
  std::map<std::array<std::uint32_t, 2>, int> times;
  for (const auto& t : filling)
    for (std::size_t k = 0; k < 3; ++k) ++times[{std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])}];
  return std::ranges::any_of(times, [&](const auto& e) { return e.second == 2 && is_taken(e.first[0], e.first[1]); });
}

/// Takes the fillings that clash with nothing.
void keep_what_fits(const RepairWork& work, const Bvh& surface, std::vector<Hole>& holes) {
  for (Hole& h : holes) h.clashes = false;
  find_clashes(work.mesh, surface, work.execution, holes);
  for (Hole& h : holes) {
    if (h.filled) continue;
    h.filled = !h.filling.empty() && !h.clashes;
    if (!h.filled) h.filling.clear();
  }
}

/// Fills what lies between loops of one plane.
void fill_islands(const RepairWork& work, const Bvh& surface, const TakenDiagonal& is_taken, std::vector<Hole>& holes) {
  std::vector<std::vector<std::uint32_t>> loops;
  for (const Hole& h : holes) loops.push_back(h.loop);
  for (FilledIslands& islands : island_fillings(work.mesh.vertices, loops)) {
    if (has_taken_diagonal(islands.filling, is_taken)) continue;
    Hole& first = holes[islands.loops[0]];
    first.filling = std::move(islands.filling);
    first.islands.assign(islands.loops.begin() + 1, islands.loops.end());
  }
  keep_what_fits(work, surface, holes);
  for (Hole& h : holes) {
    if (!h.filled) h.islands.clear();
    for (const std::uint32_t i : h.islands) holes[i].filled = true;
  }
}

/// The fillings of a loop alone, the most promising first.
Filling filling_of(Hole& hole, int attempt, std::span<const Point3> at, const TakenDiagonal& is_taken) {
  if (hole.tied) return {};
  if (attempt == 0) return planar_filling(at, hole.loop, is_taken).value_or(Filling{});
  if (attempt == 2) return little_area_filling(at, hole.loop, is_taken).value_or(Filling{});
  if (hole.loop.size() > most_for_least_area) return {};
  std::optional<LeastArea> least = least_area_filling(at, hole.loop, is_taken);
  hole.tied = least && least->tied;
  return least && !least->tied ? std::move(least->filling) : Filling{};
}

}  // namespace

void holes_step(RepairWork& work) {
  const MeshEdges edges = find_edges(work.mesh);
  std::vector<Hole> holes = holes_of(work, edges);
  if (holes.empty()) return;
  const auto is_taken = [&](std::uint32_t a, std::uint32_t b) { return !uses_between(edges, a, b).empty(); };
  const Bvh surface = build_bvh(work.mesh, {.execution = work.execution});
  fill_islands(work, surface, is_taken, holes);
  for (const int attempt : {0, 1, 2}) {
    bool any = false;
    for (Hole& h : holes) {
      if (h.filled) continue;
      h.filling = filling_of(h, attempt, work.mesh.vertices, is_taken);
      any = any || !h.filling.empty();
    }
    if (any) keep_what_fits(work, surface, holes);
  }
  for (const Hole& h : holes) {
    if (h.filled && h.filling.empty()) continue;  // an island
    if (h.filled)
      work.note(ChangeKind::filled_hole, h.loop[0], h.filling.size());
    else
      work.note_hole(h.tied ? ChangeKind::tied_hole : ChangeKind::kept_hole, h.loop, h.loop.size());
    work.mesh.triangles.insert(work.mesh.triangles.end(), h.filling.begin(), h.filling.end());
  }
}

}  // namespace plumb::surface
