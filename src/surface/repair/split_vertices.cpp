// Vertices of several fans: one vertex for each; and vertices that no triangle names: left out.
#include <algorithm>

#include "surface/repair/steps.hpp"
#include "surface/topology/around_edge.hpp"
#include "surface/topology/disjoint_sets.hpp"
#include "surface/topology/mesh_corner.hpp"

namespace plumb::surface {
namespace {

using FacePair = std::array<std::uint32_t, 2>;

/// The triangles at an edge of more than two, in pairs that bound the same solid; empty where they do not alternate.
std::vector<FacePair> pairs_around(const TriangleMesh& mesh, const std::array<std::uint32_t, 2>& edge,
                                   std::span<const EdgeUse> uses) {
  const std::vector<EdgeUse> order = order_around_edge(mesh, edge, uses);
  std::vector<FacePair> pairs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const EdgeUse &use = order[i], &next = order[(i + 1) % order.size()];
    if (use.forward == next.forward) return {};
    if (!use.forward) pairs.push_back({use.face, next.face});  // the solid is behind the first, seen counterclockwise
  }
  return pairs;
}

}  // namespace

void split_step(RepairWork& work) {
  TriangleMesh& mesh = work.mesh;
  const MeshEdges edges = find_edges(mesh);
  DisjointSets corners(3 * mesh.triangles.size());
  const auto corner = [&](std::uint32_t t, std::uint32_t v) { return 3 * t + place_of(mesh.triangles[t], v); };
  const auto keep_together = [&](const std::array<std::uint32_t, 2>& edge, std::uint32_t s, std::uint32_t t) {
    for (const std::uint32_t v : edge) corners.unite(corner(s, v), corner(t, v));
  };
  bool parted = false;
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() == 2) keep_together(edges.edges[e], uses[0].face, uses[1].face);
    if (uses.size() < 3) continue;
    parted = true;
    const std::vector<FacePair> pairs = pairs_around(mesh, edges.edges[e], uses);
    for (const auto& [s, t] : pairs) keep_together(edges.edges[e], s, t);
    if (!pairs.empty()) continue;
    for (const EdgeUse& use : uses) keep_together(edges.edges[e], uses[0].face, use.face);
  }
  const auto vertices = static_cast<std::uint32_t>(mesh.vertices.size());
  std::vector<std::uint32_t> more(vertices), number(3 * mesh.triangles.size());  // of the fan of a corner's set
  std::vector<std::uint8_t> taken(vertices);
  for (std::uint32_t c = 0; c < number.size(); ++c) {
    const TriangleMesh::Triangle& t = mesh.triangles[c / 3];
    const std::uint32_t v = t[c % 3], fan = corners.find(c);
    if (names_a_vertex_twice(t)) {
      number[c] = v;
    } else if (fan != c) {
      number[c] = number[fan];  // a set's representative is its least member
    } else if (taken[v] == 0) {
      taken[v] = 1, number[c] = v;
    } else {
      number[c] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(Point3{mesh.vertices[v]});
      ++more[v];
    }
  }
  for (std::uint32_t c = 0; c < number.size(); ++c) mesh.triangles[c / 3][c % 3] = number[c];
  for (std::uint32_t v = 0; v < vertices; ++v)
    if (more[v] != 0) work.note(ChangeKind::split_vertex, v, more[v]);
  if (!parted) return;
  outward_step(work);  // shells go on over edges that are now of two triangles
  const MeshEdges left = find_edges(mesh);
  for (std::size_t e = 0; e < left.edges.size(); ++e)
    if (left.uses_of(e).size() > 2) work.note(ChangeKind::kept_edge, left.edges[e][0], left.uses_of(e).size());
}

void unused_step(RepairWork& work) {
  TriangleMesh& mesh = work.mesh;
  std::vector<std::uint8_t> used(mesh.vertices.size());
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t) used[v] = 1;
  std::vector<std::uint32_t> number(mesh.vertices.size());
  std::uint32_t kept = 0;
  for (std::uint32_t v = 0; v < used.size(); ++v) {
    if (used[v] == 0) work.note(ChangeKind::unused_vertex, v);
    number[v] = kept;
    kept += used[v];
  }
  for (std::uint32_t v = 0; v < used.size(); ++v)
    if (used[v] != 0) mesh.vertices[number[v]] = mesh.vertices[v];
  mesh.vertices.resize(kept);
  for (auto& t : mesh.triangles)
    for (std::uint32_t& v : t) v = number[v];
}

}  // namespace plumb::surface
