// Adjacency, manifold: who neighbors whom, and is it a clean surface?
//
// Laws: edges are listed once, a < b, ascending, their faces ascending: the same mesh gives the same lists everywhere.
// Equality of vertices and zero area are exact.  A face that names a vertex twice bounds nothing: it is counted, and
// lends its edges to no list.  An index that names no vertex throws InvalidShape.
// Source: RTCD 12.2.2, 12.3, 12.4.
// Cost: linear but for the sorting of a vertex's edges, and of equal points.  Bounded by n log n operations.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"

namespace plumb {

struct EdgeUse {
  std::uint32_t face;
  std::uint32_t opposite;  // the face's third vertex
  bool forward;            // the face goes from the smaller vertex to the larger
  friend bool operator==(const EdgeUse&, const EdgeUse&) = default;
};

/// The faces of edge e are uses[first[e]] up to uses[first[e + 1]].
struct MeshEdges {
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::uint32_t> first{0};
  std::vector<EdgeUse> uses;

  [[nodiscard]] std::span<const EdgeUse> uses_of(std::size_t edge) const {
    return std::span(uses).subspan(first[edge], first[edge + 1] - first[edge]);
  }
};

MeshEdges find_edges(const TriangleMesh& mesh);

/// An edge of exactly two faces: the first, of smaller number, goes a -> b -> c; the second has d opposite the edge and
/// goes b -> a -> d, or a -> b -> d where the two are wound against each other.
struct InteriorEdge {
  std::uint32_t a, b, c, d;
  std::uint32_t face_c, face_d;
  bool consistent;
};

std::vector<InteriorEdge> interior_edges(const MeshEdges& edges);

struct MeshStatistics {
  std::uint64_t vertices = 0;
  std::uint64_t faces = 0;
  std::uint64_t edges = 0;
  std::uint64_t boundary_edges = 0;      // of one face
  std::uint64_t interior_edges = 0;      // of two
  std::uint64_t non_manifold_edges = 0;  // of more
  std::uint64_t inconsistent_edges = 0;  // of two that run the same way along it
  std::uint64_t repeated_vertices = 0;   // equal to a vertex of smaller number
  std::uint64_t unused_vertices = 0;     // named by no face
  std::uint64_t repeated_corners = 0;    // faces that name a vertex twice
  std::uint64_t zero_area_faces = 0;     // corners exactly on one line, those of repeated_corners included
};

MeshStatistics mesh_statistics(const TriangleMesh& mesh, const MeshEdges& edges);
MeshStatistics mesh_statistics(const TriangleMesh& mesh);

}  // namespace plumb
