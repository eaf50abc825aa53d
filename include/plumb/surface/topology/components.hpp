// Connected components, boundary loops, Euler's formula: of how many pieces is a mesh, how does each end, and what kind
// of surface is it?
//
//   for (const SurfaceKind& s : surface_kinds(mesh, find_edges(mesh))) print(s.euler(), s.genus());
//
// Laws: (1) components are numbered by their first triangles.  Triangles are joined over manifold edges (those of two),
// over any edge, or over any vertex that both name; each way joins what the one before does.  A triangle that names a
// vertex twice is a component of its own over edges.  (2) At a vertex a loop leaves by the other boundary of the fan by
// which it came: it keeps to one side of the surface, and passes a vertex once for each fan.  Each boundary edge is in
// one loop.  Where a fan ends at an edge of more than two triangles, the loop is an open chain that ends there.  (3) Of
// a component over manifold edges the Euler characteristic is V - E + F, its vertices counted once for each fan, its
// edges once for each two triangles that they join or one that they end; the genus is that of the surface with its
// loops closed by disks: handles where it is orientable, crosscaps (of a Moebius strip one) where it is not.  (4) All is
// combinatorial: coordinates change nothing.
// The edges are those of the mesh.
// Source: RTCD 12.2.3, 12.3; Euler and Poincare.
// Cost: linear, but for union-find.  Bounded by n log n operations.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plumb/surface/topology/topology.hpp"

namespace plumb {

enum class JoinedOver : unsigned char { manifold_edges, edges, vertices };

struct Components {
  std::vector<std::uint32_t> of;  // each triangle
  std::uint32_t count = 0;
};

Components connected_components(const TriangleMesh& mesh, const MeshEdges& edges, JoinedOver over);
/// Over vertices, which needs no edges.
Components connected_components(const TriangleMesh& mesh);

/// Vertices in the order in which the triangles beside them run, the last joined to the first; as the first triangle
/// runs, where triangles are wound against each other.
struct BoundaryLoop {
  std::vector<std::uint32_t> vertices;
  bool closed = true;  // else a chain, from an edge of more than two triangles to another
};

/// Loops are ordered by their first edges.
std::vector<BoundaryLoop> boundary_loops(const TriangleMesh& mesh, const MeshEdges& edges);

struct SurfaceKind {
  std::uint64_t vertices = 0, edges = 0, faces = 0;
  std::uint64_t loops = 0;  // of its boundary
  bool orientable = true;   // can its triangles be turned so that they agree?

  [[nodiscard]] std::int64_t euler() const {
    return static_cast<std::int64_t>(vertices + faces) - static_cast<std::int64_t>(edges);
  }
  [[nodiscard]] std::int64_t genus() const {
    const std::int64_t missing = 2 - euler() - static_cast<std::int64_t>(loops);
    return orientable ? missing / 2 : missing;
  }
  friend bool operator==(const SurfaceKind&, const SurfaceKind&) = default;
};

/// Of each component over manifold edges.
std::vector<SurfaceKind> surface_kinds(const TriangleMesh& mesh, const MeshEdges& edges);

}  // namespace plumb
