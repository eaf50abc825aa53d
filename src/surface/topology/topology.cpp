#include "plumb/surface/topology/topology.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <tuple>

#include "figure/basic/mesh_input.hpp"
#include "plumb/certify/direction.hpp"
#include "surface/topology/mesh_corner.hpp"
#include "surface/topology/triangle_lists.hpp"

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

/// Which bucket?  A guess that equal points share and few others do; -0 is 0 here.
std::uint32_t bucket_of(const Point3& p, std::size_t buckets) {
  std::uint64_t mixed = 0;
  for (const double x : {p.x, p.y, p.z}) {
    mixed = (mixed ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9e3779b97f4a7c15U;
    mixed ^= mixed >> 29;
  }
  return static_cast<std::uint32_t>((mixed * 0x9e3779b97f4a7c15U >> 32) * buckets >> 32);
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
  const surface::TriangleLists from_vertex(smaller, mesh.vertices.size());
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

std::vector<std::uint32_t> first_equal(std::span<const Point3> points) {
  // A bucket is sorted, so that there are no bad inputs.
  const std::size_t buckets = std::min<std::size_t>(points.size() + 1, std::size_t{1} << 31);
  std::vector<std::uint32_t> bucket(points.size()), first(points.size()), here;
  for (std::size_t i = 0; i < points.size(); ++i) bucket[i] = bucket_of(points[i], buckets);
  const surface::TriangleLists lists(bucket, buckets);
  for (std::size_t b = 0; b < buckets; ++b) {
    here.assign(lists[b].begin(), lists[b].end());
    std::ranges::sort(here, [&](std::uint32_t l, std::uint32_t r) {
      const Point3 &p = points[l], &q = points[r];
      return std::tie(p.x, p.y, p.z, l) < std::tie(q.x, q.y, q.z, r);
    });
    for (std::size_t i = 0; i < here.size(); ++i) {
      const bool repeats = i > 0 && points[here[i]] == points[here[i - 1]];
      first[here[i]] = repeats ? first[here[i - 1]] : here[i];
    }
  }
  return first;
}

}  // namespace plumb
