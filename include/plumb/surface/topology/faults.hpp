// What is wrong with this surface: is it closed, oriented, free of self-intersections and of degenerate triangles; of
// which shells does it consist?  All that `plumb check` says of a mesh, counted.
//
//   const SurfaceFaults f = find_faults(mesh);
//   if (f.has("open")) mend(f.open_edges);
//
// Laws: (1) closed: every edge is in an even number of triangles.  Oriented: of the triangles at an edge as many run
// along it one way as the other, but for one where their number is odd.  (2) Shells, which is inside out and which a
// wall: plumb/surface/topology/shells.hpp.  Vertices and triangles that are not as they should be: plumb/surface/topology/defects.hpp.
// (3) Edges and neighbors are those of the vertices' numbers: where vertices are repeated, triangles that meet there
// share none, and touch.  (4) All of it is decided exactly, and depends on the mesh alone, not on threads.
// A mesh that is none throws InvalidShape or NonFinite; so does a length, as close_vertices says.
// Source: RTCD 12.3, 12.4.
// Cost: that of a tree and of the pairs of triangles whose boxes meet: some 1 us a triangle, of all threads together;
// more where triangles lie on one another in heaps.  Bounded by n^2 tests of pairs, and n for each shell, on integers as
// long as the exponents' span.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "plumb/surface/topology/shells.hpp"
#include "plumb/surface/topology/topology.hpp"

namespace plumb {

/// By their names; docs/meshes.md says what each is.
inline constexpr std::array<std::string_view, 13> surface_defects{
    "open",          "unoriented",        "inside-out",          "self-intersecting",
    "degenerate",    "non-manifold-edge", "non-manifold-vertex", "vertex-on-edge",
    "duplicate",     "opposite",          "internal-wall",       "crossing-shells",
    "close-vertices"};

struct SurfaceFaults {
  bool closed = false, oriented = false;
  PairCount met;                 // pairs of triangles of the mesh
  std::uint64_t degenerate = 0;  // triangles of exactly zero area
  std::uint64_t triangles = 0, repeated_vertices = 0;
  std::vector<Shell> shells;
  std::uint64_t closed_shells = 0, inside_out_shells = 0, crossing_shells = 0, internal_walls = 0;
  std::uint64_t open_edges = 0, open_edges_of_others = 0;  // the latter of no wall
  std::uint64_t non_manifold_edges = 0, non_manifold_vertices = 0, vertices_on_edges = 0;
  std::uint64_t duplicate_triangles = 0, opposite_triangles = 0;
  std::optional<double> nearer_than;  // vertices are close that are nearer than this
  std::uint64_t close_vertices = 0;

  [[nodiscard]] bool inside_out() const { return inside_out_shells != 0; }
  [[nodiscard]] bool meets_itself() const { return met.touching + met.overlapping != 0; }
  /// One of surface_defects; InvalidShape is thrown for another name.
  [[nodiscard]] bool has(std::string_view defect) const;
  /// Has it any?
  [[nodiscard]] bool any() const;
};

struct FaultOptions {
  std::optional<double> nearer_than{};  // count close vertices as well
  Execution execution = Execution::parallel;
  Progress progress = {};  // of the pairs of triangles, which take the longest
};

/// The edges and statistics are those of the mesh.
SurfaceFaults find_faults(const TriangleMesh& mesh, const MeshEdges& edges, const MeshStatistics& statistics,
                          const FaultOptions& options = {});
SurfaceFaults find_faults(const TriangleMesh& mesh, const FaultOptions& options = {});

}  // namespace plumb
