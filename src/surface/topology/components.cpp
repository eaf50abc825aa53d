#include "plumb/surface/topology/components.hpp"

#include <algorithm>

#include "plumb/surface/topology/adjacency.hpp"
#include "surface/topology/disjoint_sets.hpp"
#include "surface/topology/windings.hpp"

namespace plumb {
namespace {

constexpr std::uint32_t unnumbered = std::numeric_limits<std::uint32_t>::max();

/// Numbers sets by the first of `n` things in each; of(i) is the thing's member.
template <class Of>
Components numbered(std::uint32_t n, surface::DisjointSets& sets, std::size_t members, const Of& of) {
  Components found;
  found.of.resize(n);
  std::vector<std::uint32_t> number(members, unnumbered);
  for (std::uint32_t i = 0; i < n; ++i) {
    std::uint32_t& mine = number[sets.find(of(i))];
    if (mine == unnumbered) mine = found.count++;
    found.of[i] = mine;
  }
  return found;
}

/// The sides of triangles that bound what manifold edges join: half-edges whose edge is not in exactly two triangles.
class Sides {
 public:
  Sides(const TriangleMesh& mesh, const MeshEdges& edges)
      : mesh_(mesh), edges_(edges), edge_(edges_of_faces(mesh, edges)) {}

  [[nodiscard]] std::uint32_t edge(std::uint32_t h) const { return edge_[h / 3][h % 3]; }
  [[nodiscard]] std::size_t uses(std::uint32_t h) const {
    return edge(h) == no_edge ? 0 : edges_.uses_of(edge(h)).size();
  }
  [[nodiscard]] bool is_side(std::uint32_t h) const { return edge(h) != no_edge && uses(h) != 2; }
  [[nodiscard]] std::uint32_t from(std::uint32_t h) const { return mesh_.triangles[h / 3][h % 3]; }
  [[nodiscard]] std::uint32_t to(std::uint32_t h) const { return from(next_half_edge(h)); }

  /// The other side of the fan at vertex v, which is an end of this one.
  [[nodiscard]] std::uint32_t around(std::uint32_t h, std::uint32_t v) const {
    for (;;) {
      h = from(h) == v ? previous_half_edge(h) : next_half_edge(h);  // the triangle's other edge at v
      const auto at = edges_.uses_of(edge(h));
      if (at.size() != 2) return h;
      const std::uint32_t face = at[0].face == h / 3 ? at[1].face : at[0].face;
      for (std::uint32_t k = 3 * face; k < 3 * face + 3; ++k) {
        if (edge(k) == edge(h)) {
          h = k;
          break;
        }
      }
    }
  }

 private:
  const TriangleMesh& mesh_;
  const MeshEdges& edges_;
  std::vector<std::array<std::uint32_t, 3>> edge_;
};

/// Calls visit(side, the vertex that it is left by) along the loop of a side, from its own on, until visit says no or
/// it is there again; forward as the side's triangle runs, or the other way.
template <class Visit>
void walk(const Sides& sides, std::uint32_t start, bool forward, const Visit& visit) {
  std::uint32_t h = start, leaves = forward ? sides.to(h) : sides.from(h);
  for (;;) {
    if (!visit(h, leaves)) return;
    h = sides.around(h, leaves);
    if (h == start) return;
    leaves = sides.from(h) == leaves ? sides.to(h) : sides.from(h);
  }
}

}  // namespace

Components connected_components(const TriangleMesh& mesh) {
  surface::DisjointSets sets(mesh.vertices.size());
  for (const auto& [a, b, c] : mesh.triangles) sets.unite(a, b), sets.unite(b, c);
  return numbered(static_cast<std::uint32_t>(mesh.triangles.size()), sets, mesh.vertices.size(),
                  [&](std::uint32_t f) { return mesh.triangles[f][0]; });
}

Components connected_components(const TriangleMesh& mesh, const MeshEdges& edges, JoinedOver over) {
  if (over == JoinedOver::vertices) return connected_components(mesh);
  const auto n = static_cast<std::uint32_t>(mesh.triangles.size());
  surface::DisjointSets sets(n);
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (over == JoinedOver::manifold_edges && uses.size() != 2) continue;
    for (std::size_t i = 1; i < uses.size(); ++i) sets.unite(uses[0].face, uses[i].face);
  }
  return numbered(n, sets, n, [](std::uint32_t f) { return f; });
}

std::vector<BoundaryLoop> boundary_loops(const TriangleMesh& mesh, const MeshEdges& edges) {
  const Sides sides(mesh, edges);
  std::vector<BoundaryLoop> loops;
  std::vector<bool> passed(edges.edges.size());
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() != 1 || passed[e]) continue;
    std::uint32_t start = 3 * uses[0].face;
    while (sides.edge(start) != e) ++start;
    BoundaryLoop loop;
    const auto take = [&](std::uint32_t h, std::uint32_t v) {
      loop.closed = sides.uses(h) == 1;
      if (!loop.closed) return false;
      passed[sides.edge(h)] = true;
      loop.vertices.push_back(v);
      return true;
    };
    walk(sides, start, true, take);
    if (!loop.closed) {  // the other end, which may lie before the start
      std::vector<std::uint32_t> chain = std::move(loop.vertices);
      loop.vertices.clear();
      walk(sides, start, false, take);
      std::ranges::reverse(loop.vertices);
      loop.vertices.insert(loop.vertices.end(), chain.begin(), chain.end());
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

std::vector<SurfaceKind> surface_kinds(const TriangleMesh& mesh, const MeshEdges& edges) {
  const surface::Windings windings = surface::find_windings(mesh, edges);
  const auto& of = windings.components.of;
  std::vector<SurfaceKind> kinds(windings.components.count);
  for (std::size_t c = 0; c < kinds.size(); ++c) kinds[c].orientable = windings.orientable[c] != 0;
  for (const std::uint32_t c : of) ++kinds[c].faces;
  surface::DisjointSets corners(3 * mesh.triangles.size());
  const Sides sides(mesh, edges);
  const auto corner = [&](std::uint32_t f, std::uint32_t v) {
    const auto& t = mesh.triangles[f];
    return 3 * f + (t[0] == v ? 0U : t[1] == v ? 1U : 2U);
  };
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() == 2) {
      ++kinds[of[uses[0].face]].edges;
      for (const std::uint32_t v : edges.edges[e]) corners.unite(corner(uses[0].face, v), corner(uses[1].face, v));
    } else {
      for (const EdgeUse& use : uses) ++kinds[of[use.face]].edges;
    }
  }
  std::vector<bool> passed(3 * mesh.triangles.size());
  for (std::uint32_t h = 0; h < passed.size(); ++h) {
    if (sides.edge(h) == no_edge) continue;
    kinds[of[h / 3]].vertices += corners.find(h) == h;
    if (!sides.is_side(h) || passed[h]) continue;
    ++kinds[of[h / 3]].loops;
    walk(sides, h, true, [&](std::uint32_t k, std::uint32_t) { return passed[k] = true; });
  }
  return kinds;
}

}  // namespace plumb
