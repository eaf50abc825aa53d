#include "surface/topology/internal_walls.hpp"

#include <algorithm>
#include <vector>

#include "figure/basic/lists_by_number.hpp"
#include "surface/topology/around_edge.hpp"
#include "surface/topology/disjoint_sets.hpp"
#include "surface/topology/signed_volume.hpp"

namespace plumb::surface {
namespace {

/// The sides of triangle t: 2 t is the one that its normal points to, 2 t + 1 the other.
std::uint32_t side(const EdgeUse& use, bool forward_faces_front) {
  return 2 * use.face + (use.forward == forward_faces_front ? 0 : 1);
}
/// The side that looks counterclockwise around the edge, seen from its larger vertex; and that which looks clockwise.
std::uint32_t side_after(const EdgeUse& use) { return side(use, true); }
std::uint32_t side_before(const EdgeUse& use) { return side(use, false); }

bool may_hold_walls(const MeshEdges& edges, const Shells& found) {
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() > 2 &&
        std::ranges::any_of(uses, [&](const EdgeUse& use) { return !found.shells[found.shell_of[use.face]].closed; }))
      return true;
  }
  return false;
}

}  // namespace

void find_dividing_walls(const TriangleMesh& mesh, const MeshEdges& edges, Shells& found) {
  if (!may_hold_walls(edges, found)) return;
  const auto n = static_cast<std::uint32_t>(mesh.triangles.size());
  DisjointSets sides(2 * std::size_t{n}), surfaces(n);
  std::vector<bool> unclear(n);  // by the representatives of surfaces, in the end
  std::vector<std::uint32_t> unclear_at;
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    for (const EdgeUse& use : uses) surfaces.unite(uses[0].face, use.face);
    const std::vector<EdgeUse> sorted =
        uses.size() > 2 ? order_around_edge(mesh, edges.edges[e], uses) : std::vector<EdgeUse>{};
    if (uses.size() > 2 && sorted.empty()) unclear_at.push_back(uses[0].face);
    const std::span<const EdgeUse> order = uses.size() > 2 ? std::span<const EdgeUse>(sorted) : uses;
    for (std::size_t i = 0; i < order.size(); ++i)
      sides.unite(side_after(order[i]), side_before(order[(i + 1) % order.size()]));
  }
  for (const std::uint32_t t : unclear_at) unclear[surfaces.find(t)] = true;

  std::vector<std::uint32_t> cell_of(2 * std::size_t{n});
  for (std::uint32_t s = 0; s < 2 * n; ++s) cell_of[s] = sides.find(s);
  const figure::ListsByNumber cells(cell_of, 2 * std::size_t{n});  // of sides
  std::vector<std::uint32_t> outer(n, no_shell);                   // of each surface
  std::vector<bool> is_outer(2 * std::size_t{n});
  for (std::uint32_t c = 0; c < 2 * n; ++c) {
    if (cells[c].empty() || found.shell_of[c / 2] == no_shell) continue;
    const std::uint32_t surface = surfaces.find(c / 2);
    // What bounds a cell turns outward, seen from the cell, where a side looks into it.
    const Sign volume = sign_of_volume(mesh, cells[c], [](std::uint32_t s) {
      return SidedTriangle{s / 2, s % 2 == 0};
    });
    if (volume == Sign::positive) continue;
    is_outer[c] = true;
    if (outer[surface] != no_shell) unclear[surface] = true;
    outer[surface] = c;
  }
  for (Shell& s : found.shells) s.wall = !s.closed && !unclear[surfaces.find(s.first_triangle)];
  for (std::uint32_t t = 0; t < n; ++t) {
    const std::uint32_t s = found.shell_of[t];
    if (s != no_shell && (is_outer[cell_of[2 * t]] || is_outer[cell_of[2 * t + 1]])) found.shells[s].wall = false;
  }
}

}  // namespace plumb::surface
