#include "surface/parts/sound_solid.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <string>

#include "arith/shortest_decimal.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "plumb/surface/topology/shells.hpp"
#include "surface/topology/disjoint_sets.hpp"

namespace plumb::surface {
namespace {

std::string number(std::uint32_t n) { return std::to_string(n); }

[[noreturn]] void refuse(const char* question, const std::string& what) {
  throw InvalidShape(std::string(question) + ": " + what);
}

std::string place(const Point3& p) {
  return "(" + arith::shortest_decimal(p.x) + ", " + arith::shortest_decimal(p.y) + ", " +
         arith::shortest_decimal(p.z) + ")";
}

/// What is at an edge whose triangles do not take turns.
[[noreturn]] void refuse_edge(const char* question, const SoundSolid& solid, const CutCell& whole,
                              const std::array<std::uint32_t, 2>& edge) {
  int forward = 0, backward = 0;
  std::string triangles;
  for (std::uint32_t t = 0; t < whole.size(); ++t) {
    for (const CutEdge& e : whole[t].edges) {
      if (!((e.from == edge[0] && e.to == edge[1]) || (e.from == edge[1] && e.to == edge[0]))) continue;
      ++(e.from == edge[0] ? forward : backward);
      triangles += (triangles.empty() ? "" : ", ") + number(solid.given[t]);
    }
  }
  const std::string where = "the edge from " + place(solid.mesh.vertices[edge[0]]) + " to " +
                            place(solid.mesh.vertices[edge[1]]) + ", of triangle " + triangles;
  if ((forward + backward) % 2 != 0) refuse(question, "the mesh is open at " + where + "; close it, or repair it");
  if (forward != backward) refuse(question, "triangles run against each other along " + where + "; repair winds them");
  refuse(question, "triangles lie on one another at " + where);
}

/// A copy of each vertex for each fan of triangles at it that wedges join, so that what only touches is apart.
TriangleMesh parted_at_edges(const SoundSolid& solid, const CellEdges& edges) {
  const auto corner_at = [&](std::uint32_t t, std::uint32_t v) {
    const auto& corners = solid.mesh.triangles[t];
    return 3 * t + static_cast<std::uint32_t>(std::ranges::find(corners, v) - corners.begin());
  };
  DisjointSets fans(3 * solid.mesh.triangles.size());
  for (const WedgedEdge& e : edges.edges)
    for (const EdgeWedge& w : edges.wedges_of(e))
      for (const std::uint32_t v : {e.a, e.b}) fans.unite(corner_at(w.facet, v), corner_at(w.to_facet, v));
  TriangleMesh parted;
  std::vector<std::uint32_t> copy(3 * solid.mesh.triangles.size());
  for (std::uint32_t t = 0; t < solid.mesh.triangles.size(); ++t) {
    TriangleMesh::Triangle corners;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t c = 3 * t + i;
      if (fans.find(c) == c) {
        copy[c] = static_cast<std::uint32_t>(parted.vertices.size());
        parted.vertices.push_back(solid.mesh.vertices[solid.mesh.triangles[t][i]]);
      }
      corners[i] = copy[fans.find(c)];
    }
    parted.triangles.push_back(corners);
  }
  return parted;
}

/// Numbers, for each triangle, the outer shell to which it belongs.
std::vector<std::uint32_t> group_of_triangles(const char* question, const SoundSolid& solid, const Shells& found) {
  for (const Shell& s : found.shells) {
    const std::string shell = "the shell of triangle " + number(solid.given[s.first_triangle]);
    if (!s.closed || !s.oriented) refuse(question, shell + " is not closed and wound one way");
    if (s.inside_out())
      refuse(question, shell + (s.depth % 2 == 0 ? " is inside out: it is wound inward, and in no other"
                                                 : " is inside out: it is wound outward, and lies in another"));
  }
  if (!found.crossing.empty()) {
    const auto& [a, b] = found.crossing.front();
    refuse(question, "the shells of triangles " + number(solid.given[found.shells[a].first_triangle]) + " and " +
                         number(solid.given[found.shells[b].first_triangle]) + " cross");
  }
  std::vector<std::uint32_t> group(found.shell_of.size());
  for (std::size_t t = 0; t < group.size(); ++t) {
    const std::uint32_t s = found.shell_of[t];
    group[t] = found.shells[s].depth % 2 == 0 ? s : *found.shells[s].parent;
  }
  return group;
}

void require_no_crossing(const char* question, const SoundSolid& solid, const std::vector<std::uint32_t>& group,
                         const CutSpace& space) {
  for (const TrianglePair& p : intersecting_pairs(build_bvh(solid.mesh), {.touching = false})) {
    // Two solids may stand against each other: what is between the walls belongs to neither.
    const bool walls = group[p.a] != group[p.b] && space.plane_of(p.a) == space.plane_of(p.b) &&
                       space.is_turned(p.a) != space.is_turned(p.b);
    if (!walls)
      refuse(question, "triangles " + number(std::min(solid.given[p.a], solid.given[p.b])) + " and " +
                           number(std::max(solid.given[p.a], solid.given[p.b])) + " cross or lie on one another");
  }
}

}  // namespace

SoundSolid in_canonical_order(const char* question, const TriangleMesh& mesh) {
  const auto require_finite = [&](std::uint32_t v) {
    const Point3& p = mesh.vertices[v];
    if (!(p.x - p.x == 0 && p.y - p.y == 0 && p.z - p.z == 0))
      throw NonFinite(std::string(question) + ": vertex " + number(v) + " is " + place(p) +
                      ", not a point; give finite coordinates");
  };
  std::vector<std::uint32_t> used;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      if (v >= mesh.vertices.size())
        refuse(question, "triangle " + number(t) + " names vertex " + number(v) + ", and there are " +
                             std::to_string(mesh.vertices.size()));
      require_finite(v);
      used.push_back(v);
    }
    const auto& [a, b, c] = mesh.triangles[t];
    if (collinear(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]))
      refuse(question, "triangle " + number(t) + " has no area; repair removes those");
  }
  const auto compare = [&](std::uint32_t a, std::uint32_t b) {
    return compare_lexicographically(mesh.vertices[a], mesh.vertices[b]);
  };
  std::ranges::sort(used, [&](std::uint32_t a, std::uint32_t b) { return compare(a, b) == Sign::negative; });
  SoundSolid solid;
  std::vector<std::uint32_t> number_of(mesh.vertices.size());
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (i == 0 || compare(used[i - 1], used[i]) != Sign::zero) {
      const Point3& p = mesh.vertices[used[i]];
      solid.mesh.vertices.push_back({p.x + 0.0, p.y + 0.0, p.z + 0.0});  // no zero has a sign
    }
    number_of[used[i]] = static_cast<std::uint32_t>(solid.mesh.vertices.size() - 1);
  }
  std::vector<std::pair<TriangleMesh::Triangle, std::uint32_t>> triangles;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    TriangleMesh::Triangle corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = number_of[mesh.triangles[t][i]];
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    triangles.emplace_back(corners, t);
  }
  std::ranges::sort(triangles);
  for (const auto& [corners, t] : triangles) {
    solid.mesh.triangles.push_back(corners);
    solid.given.push_back(t);
  }
  return solid;
}

std::vector<CutCell> solids_of(const char* question, const SoundSolid& solid, CutSpace& space) {
  CutCell whole;
  for (std::uint32_t t = 0; t < solid.mesh.triangles.size(); ++t) {
    CutFacet facet{space.plane_of(t), space.is_turned(t), false, t, {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = solid.mesh.triangles[t][i], to = solid.mesh.triangles[t][(i + 1) % 3];
      facet.edges.push_back({from, to, {std::min(from, to), std::max(from, to), false}});
    }
    whole.push_back(std::move(facet));
  }
  const CellEdges edges = edges_of(space, whole);
  if (edges.flaw) refuse_edge(question, solid, whole, *edges.flaw);
  const Shells shells = find_shells(parted_at_edges(solid, edges));
  const std::vector<std::uint32_t> group = group_of_triangles(question, solid, shells);
  require_no_crossing(question, solid, group, space);
  std::map<std::uint32_t, CutCell> cells;
  for (std::uint32_t t = 0; t < whole.size(); ++t) {
    whole[t].of_cavity = shells.shell_of[t] != group[t];
    cells[group[t]].push_back(std::move(whole[t]));
  }
  std::vector<CutCell> solids;
  for (auto& [first, cell] : cells) solids.push_back(std::move(cell));
  return solids;
}

}  // namespace plumb::surface
