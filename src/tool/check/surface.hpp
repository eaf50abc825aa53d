// Is this mesh the surface of a solid: closed, oriented, free of self-intersections and of degenerate triangles; of
// which shells does it consist, and what else is wrong with it?
//
// Laws: (1) closed: every edge is in an even number of triangles.  Oriented: of the triangles at an edge as many run
// along it one way as the other, but for one where their number is odd.  (2) Shells, which is inside out and which a
// wall: plumb/surface/shells.hpp.  Vertices and triangles that are not as they should be: plumb/surface/defects.hpp.
// (3) Edges and neighbors are those of the vertices' numbers: where vertices are repeated, triangles that meet there
// share none, and touch.  (4) All of it is decided exactly; a volume that rounds to zero has a sign.  (5) It depends on
// the mesh alone, not on threads.
// Source: RTCD 12.3, 12.4.
// Cost: that of a tree and of the pairs of triangles whose boxes meet: some 1 us a triangle, of all threads together;
// more where triangles lie on one another in heaps.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/surface/shells.hpp"
#include "plumb/surface/topology.hpp"

namespace plumb::tool {

/// What --fail-on-defect takes; the manual says what each is.
inline constexpr std::array<std::string_view, 13> surface_defects{
    "open",          "unoriented",        "inside-out",          "self-intersecting",
    "degenerate",    "non-manifold-edge", "non-manifold-vertex", "vertex-on-edge",
    "duplicate",     "opposite",          "internal-wall",       "crossing-shells",
    "close-vertices"};

struct SurfaceCheck {
  bool closed = false, oriented = false;
  PairCount met;                 // pairs of triangles of the mesh
  std::uint64_t degenerate = 0;  // triangles of exactly zero area
  std::uint64_t triangles = 0, repeated_vertices = 0;
  std::vector<Shell> shells;
  std::uint64_t closed_shells = 0, inside_out_shells = 0, crossing_shells = 0, internal_walls = 0;
  std::uint64_t open_edges_of_others = 0;  // that are of no wall
  std::uint64_t non_manifold_edges = 0, non_manifold_vertices = 0, vertices_on_edges = 0;
  std::uint64_t duplicate_triangles = 0, opposite_triangles = 0;
  std::optional<double> nearer_than;  // vertices are close that are nearer than this
  std::uint64_t close_vertices = 0;

  [[nodiscard]] bool inside_out() const { return inside_out_shells != 0; }
  [[nodiscard]] bool meets_itself() const { return met.touching + met.overlapping != 0; }
  /// One of surface_defects.
  [[nodiscard]] bool has(std::string_view defect) const;
};

/// The name stands at a bar of progress.
SurfaceCheck check_surface(const TriangleMesh& mesh, const MeshEdges& edges, const MeshStatistics& statistics,
                           const std::string& name, std::optional<double> nearer_than = {});

/// "2 shells, closed, oriented, free of self-intersections, free of degenerate triangles"
std::string surface_verdict(const SurfaceCheck& check);

/// "turn shell 1": what the shells that are inside out ask for.
std::string turning_advice(const SurfaceCheck& check);

/// The numbers of the shells that a report of at most so many shows: what is wrong first, in their order.
std::vector<std::size_t> shown_shells(const SurfaceCheck& check, std::size_t most);

}  // namespace plumb::tool
