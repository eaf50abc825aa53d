// Adjacency: which triangles are at a vertex, which edges bound a triangle, and who is on the other side?
//
//   const FacesAtVertices at = faces_at_vertices(mesh);              // of any mesh
//   const HalfEdges half = half_edges(mesh, find_edges(mesh));       // of what is manifold, and what is not
//   for (std::uint32_t h = first; h != no_half_edge; h = half.twin[next_half_edge(h)]) ...
//
// Half-edge 3 f + k runs from corner k of triangle f to its next corner.  Tables are flat arrays, by number.
// Laws: (1) a half-edge has a twin where its edge is in exactly two triangles, which run along it in opposite
// directions; the twin of the twin is itself.  (2) Edges that have no twins are boundaries, in one triangle, or listed:
// in `crowded` where they are in more than two, in `opposed` where their two triangles are wound against each other.
// (3) A triangle that names a vertex twice is at its vertices, once each, and has neither edges nor twins.  (4) Lists
// ascend.
// The edges are those of the mesh.
// Source: RTCD 12.2.1, 12.2.2; winged edges: Baumgart 1975.
// Cost: linear.  Nothing is searched.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "plumb/surface/topology/topology.hpp"

namespace plumb {

/// The triangles at vertex v are faces[first[v]] up to faces[first[v + 1]].
struct FacesAtVertices {
  std::vector<std::uint32_t> first{0};
  std::vector<std::uint32_t> faces;

  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t vertex) const {
    return std::span(faces).subspan(first[vertex], first[vertex + 1] - first[vertex]);
  }
};

FacesAtVertices faces_at_vertices(const TriangleMesh& mesh);

inline constexpr std::uint32_t no_edge = std::numeric_limits<std::uint32_t>::max(), no_half_edge = no_edge;

/// Of each triangle the numbers of its edges in MeshEdges, that of half-edge 3 f + k in place k; no_edge where it has
/// none.  The triangles next to f are those that use these.
std::vector<std::array<std::uint32_t, 3>> edges_of_faces(const TriangleMesh& mesh, const MeshEdges& edges);

struct HalfEdges {
  std::vector<std::uint32_t> twin;                        // or no_half_edge
  std::vector<std::uint32_t> boundary, crowded, opposed;  // numbers of edges
};

constexpr std::uint32_t next_half_edge(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
constexpr std::uint32_t previous_half_edge(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

HalfEdges half_edges(const TriangleMesh& mesh, const MeshEdges& edges);

/// An edge with its wings: half-edges in the triangle that runs from a to b, and in the other, before and after it.
struct WingedEdge {
  std::uint32_t a, b;         // a < b, but where one triangle alone has it and runs from the larger to the smaller
  std::uint32_t left, right;  // its half-edges from a to b and from b to a; the latter, and its wings, may be missing
  std::uint32_t left_before, left_after, right_before, right_after;
  friend bool operator==(const WingedEdge&, const WingedEdge&) = default;
};

/// Of the edges that are not listed as crowded or opposed, in their order.
std::vector<WingedEdge> winged_edges(const TriangleMesh& mesh, const MeshEdges& edges, const HalfEdges& half);

}  // namespace plumb
