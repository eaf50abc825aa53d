// Is this mesh the surface of a solid: closed, oriented, free of self-intersections and of degenerate triangles?
//
// Laws: (1) closed: every edge is in an even number of triangles.  Oriented: of the triangles at an edge as many run
// along it one way as the other, but for one where their number is odd.  (2) inside_out: closed, oriented, and of
// negative volume.  (3) Edges and neighbors are those of the vertices' numbers: where vertices are repeated, triangles
// that meet there share none, and touch.  (4) All of it is decided exactly; a volume that rounds to zero is no negative
// one.  (5) It depends on the mesh alone, not on threads.
// Source: RTCD 12.3, 12.4; plumb/space/pairs/mesh_pairs.hpp.
// Cost: that of a tree and of the pairs of triangles whose boxes meet: some 1 us a triangle, of all threads together;
// more where triangles lie on one another in heaps.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "plumb/space/pairs/mesh_pairs.hpp"
#include "plumb/surface/topology.hpp"

namespace plumb::tool {

/// What --fail-on-defect takes.
inline constexpr std::array<std::string_view, 5> surface_defects{"open", "unoriented", "inside-out",
                                                                 "self-intersecting", "degenerate"};

struct SurfaceCheck {
  bool closed = false, oriented = false, inside_out = false;
  PairCount met;                 // pairs of triangles of the mesh
  std::uint64_t degenerate = 0;  // triangles of exactly zero area
  std::uint64_t triangles = 0, repeated_vertices = 0;

  [[nodiscard]] bool meets_itself() const { return met.touching + met.overlapping != 0; }
  /// One of surface_defects.
  [[nodiscard]] bool has(std::string_view defect) const;
};

/// The name stands at a bar of progress.
SurfaceCheck check_surface(const TriangleMesh& mesh, const MeshEdges& edges, const MeshStatistics& statistics,
                           const std::string& name);

/// "closed, oriented, free of self-intersections, free of degenerate triangles"
std::string surface_verdict(const SurfaceCheck& check);

}  // namespace plumb::tool
