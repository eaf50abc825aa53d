#include "plumb/surface/topology/topology.hpp"

#include <algorithm>
#include <limits>

#include "figure/basic/lists_by_number.hpp"
#include "figure/basic/mesh_input.hpp"
#include "plumb/certify/direction.hpp"
#include "plumb/figure/basic/equal_points.hpp"
#include "surface/topology/mesh_corner.hpp"

namespace plumb {
namespace {

struct UseOfEdge {
  std::uint32_t to;  // the larger vertex
  EdgeUse use;
};

/// The use that begins in place h % 3 of triangle h / 3; its smaller vertex.
UseOfEdge use_at(const TriangleMesh& mesh, std::uint32_t h) {
  const TriangleMesh::Triangle& t = mesh.triangles[h / 3];
  const std::uint32_t from = t[h % 3], to = t[(h + 1) % 3];
  return {std::max(from, to), {h / 3, t[(h + 2) % 3], from < to}};
}

}  // namespace

MeshEdges find_edges(const TriangleMesh& mesh) {
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t)
      if (v >= mesh.vertices.size()) require_mesh("find_edges", mesh);
  std::vector<std::uint32_t> smaller(3 * mesh.triangles.size(), std::numeric_limits<std::uint32_t>::max());
  for (std::size_t h = 0; h < smaller.size(); ++h) {
    const TriangleMesh::Triangle& t = mesh.triangles[h / 3];
    if (!surface::names_a_vertex_twice(t)) smaller[h] = std::min(t[h % 3], t[(h + 1) % 3]);
  }
  const figure::ListsByNumber from_vertex(smaller, mesh.vertices.size());
  MeshEdges found;
  found.uses.reserve(smaller.size());
  found.edges.reserve(smaller.size() / 2);
  found.first.reserve(smaller.size() / 2 + 1);
  std::vector<UseOfEdge> of_vertex;
  for (std::uint32_t a = 0; a < mesh.vertices.size(); ++a) {
    of_vertex.clear();
    for (const std::uint32_t h : from_vertex[a]) of_vertex.push_back(use_at(mesh, h));
    std::ranges::sort(of_vertex, [](const UseOfEdge& l, const UseOfEdge& r) {
      return l.to != r.to ? l.to < r.to : l.use.face < r.use.face;
    });
    for (std::size_t i = 0; i < of_vertex.size(); ++i) {
      if (i == 0 || of_vertex[i].to != of_vertex[i - 1].to) {
        found.edges.push_back({a, of_vertex[i].to});
        found.first.push_back(found.first.back());
      }
      found.uses.push_back(of_vertex[i].use);
      ++found.first.back();
    }
  }
  return found;
}

std::vector<InteriorEdge> interior_edges(const MeshEdges& edges) {
  std::vector<InteriorEdge> interior;
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() != 2) continue;
    auto [a, b] = edges.edges[e];
    if (!uses[0].forward) std::swap(a, b);
    interior.push_back(
        {a, b, uses[0].opposite, uses[1].opposite, uses[0].face, uses[1].face, uses[0].forward != uses[1].forward});
  }
  return interior;
}

MeshStatistics mesh_statistics(const TriangleMesh& mesh, const MeshEdges& edges) {
  MeshStatistics said;
  said.vertices = mesh.vertices.size();
  said.faces = mesh.triangles.size();
  said.edges = edges.edges.size();
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    said.boundary_edges += uses.size() == 1;
    said.interior_edges += uses.size() == 2;
    said.non_manifold_edges += uses.size() > 2;
    said.inconsistent_edges += uses.size() == 2 && uses[0].forward == uses[1].forward;
  }
  const auto first = first_equal(mesh.vertices);
  for (std::size_t v = 0; v < first.size(); ++v) said.repeated_vertices += first[v] != v;
  std::vector<bool> used(mesh.vertices.size());
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) used[v] = true;
    said.repeated_corners += surface::names_a_vertex_twice(t);
    said.zero_area_faces += collinear(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
  }
  said.unused_vertices = static_cast<std::uint64_t>(std::count(used.begin(), used.end(), false));
  return said;
}

MeshStatistics mesh_statistics(const TriangleMesh& mesh) { return mesh_statistics(mesh, find_edges(mesh)); }

}  // namespace plumb
