#include "plumb/surface/topology/adjacency.hpp"

#include "surface/topology/mesh_corner.hpp"

namespace plumb {
namespace {

/// The half-edge of edge e in one of its triangles.
std::uint32_t half_edge_of(const TriangleMesh& mesh, const std::array<std::uint32_t, 2>& edge, const EdgeUse& use) {
  return 3 * use.face + surface::place_of(mesh.triangles[use.face], use.forward ? edge[0] : edge[1]);
}

}  // namespace

FacesAtVertices faces_at_vertices(const TriangleMesh& mesh) {
  FacesAtVertices at;
  at.first.assign(mesh.vertices.size() + 2, 0);
  const auto for_each_vertex = [&](const auto& visit) {
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
      const auto& [a, b, c] = mesh.triangles[f];
      visit(a, f);
      if (b != a) visit(b, f);
      if (c != a && c != b) visit(c, f);
    }
  };
  for_each_vertex([&](std::uint32_t v, std::uint32_t) { ++at.first[v + 2]; });
  for (std::size_t v = 2; v < at.first.size(); ++v) at.first[v] += at.first[v - 1];
  at.faces.resize(at.first.back());
  for_each_vertex([&](std::uint32_t v, std::uint32_t f) { at.faces[at.first[v + 1]++] = f; });
  at.first.pop_back();
  return at;
}

std::vector<std::array<std::uint32_t, 3>> edges_of_faces(const TriangleMesh& mesh, const MeshEdges& edges) {
  std::vector<std::array<std::uint32_t, 3>> of_faces(mesh.triangles.size(), {no_edge, no_edge, no_edge});
  for (std::uint32_t e = 0; e < edges.edges.size(); ++e) {
    for (const EdgeUse& use : edges.uses_of(e)) {
      const std::uint32_t h = half_edge_of(mesh, edges.edges[e], use);
      of_faces[h / 3][h % 3] = e;
    }
  }
  return of_faces;
}

HalfEdges half_edges(const TriangleMesh& mesh, const MeshEdges& edges) {
  HalfEdges found;
  found.twin.assign(3 * mesh.triangles.size(), no_half_edge);
  for (std::uint32_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() == 1) {
      found.boundary.push_back(e);
    } else if (uses.size() > 2) {
      found.crowded.push_back(e);
    } else if (uses[0].forward == uses[1].forward) {
      found.opposed.push_back(e);
    } else {
      const std::uint32_t h = half_edge_of(mesh, edges.edges[e], uses[0]),
                          k = half_edge_of(mesh, edges.edges[e], uses[1]);
      found.twin[h] = k, found.twin[k] = h;
    }
  }
  return found;
}

std::vector<WingedEdge> winged_edges(const TriangleMesh& mesh, const MeshEdges& edges, const HalfEdges& half) {
  std::vector<WingedEdge> found;
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() > 2 || (uses.size() == 2 && uses[0].forward == uses[1].forward)) continue;
    const EdgeUse& use = uses[uses.size() == 2 && !uses[0].forward ? 1 : 0];
    const std::uint32_t left = half_edge_of(mesh, edges.edges[e], use), right = half.twin[left];
    auto [a, b] = edges.edges[e];
    if (!use.forward) std::swap(a, b);
    WingedEdge& w = found.emplace_back(
        WingedEdge{a, b, left, right, previous_half_edge(left), next_half_edge(left), no_half_edge, no_half_edge});
    if (right != no_half_edge) w.right_before = previous_half_edge(right), w.right_after = next_half_edge(right);
  }
  return found;
}

}  // namespace plumb
