#include "plumb/surface/topology.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "plumb/certify/direction.hpp"
#include "surface/topology/mesh_corner.hpp"

namespace plumb {
namespace {

struct Use {
  std::uint32_t a, b;  // a < b
  EdgeUse use;
};

std::vector<Use> sorted_uses(const TriangleMesh& mesh) {
  std::vector<Use> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    const TriangleMesh::Triangle& t = mesh.triangles[f];
    if (surface::names_a_vertex_twice(t)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k], to = t[(k + 1) % 3];
      uses.push_back(
          {std::min(from, to), std::max(from, to), {static_cast<std::uint32_t>(f), t[(k + 2) % 3], from < to}});
    }
  }
  std::sort(uses.begin(), uses.end(),
            [](const Use& l, const Use& r) { return std::tie(l.a, l.b, l.use.face) < std::tie(r.a, r.b, r.use.face); });
  return uses;
}

}  // namespace

MeshEdges find_edges(const TriangleMesh& mesh) {
  MeshEdges found;
  const auto uses = sorted_uses(mesh);
  found.uses.reserve(uses.size());
  for (const Use& use : uses) {
    if (found.edges.empty() || found.edges.back()[0] != use.a || found.edges.back()[1] != use.b) {
      found.edges.push_back({use.a, use.b});
      found.first.push_back(found.first.back());
    }
    found.uses.push_back(use.use);
    ++found.first.back();
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

std::vector<std::uint32_t> first_equal(std::span<const Point3> points) {
  // Sorting, unlike hashing, has no bad inputs.
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t l, std::uint32_t r) {
    const Point3 &p = points[l], &q = points[r];
    return std::tie(p.x, p.y, p.z, l) < std::tie(q.x, q.y, q.z, r);
  });
  std::vector<std::uint32_t> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && points[order[i]] == points[order[i - 1]];
    first[order[i]] = repeats ? first[order[i - 1]] : order[i];
  }
  return first;
}

}  // namespace plumb
