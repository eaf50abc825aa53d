#include "plumb/surface/topology/faults.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "plumb/arith/error.hpp"
#include "plumb/surface/topology/defects.hpp"

namespace plumb {
namespace {

std::vector<CoincidentTriangle> coincident_triangles_of(const TriangleMesh& mesh, const MeshStatistics& statistics) {
  if (statistics.repeated_vertices != 0) return coincident_triangles(mesh);
  std::vector<std::uint32_t> own(mesh.vertices.size());  // equal to none of smaller number
  std::iota(own.begin(), own.end(), 0U);
  return coincident_triangles(mesh, own);
}

}  // namespace

bool SurfaceFaults::has(std::string_view defect) const {
  const std::array<bool, surface_defects.size()> found{!closed,
                                                       !oriented,
                                                       inside_out(),
                                                       meets_itself(),
                                                       degenerate != 0,
                                                       non_manifold_edges != 0,
                                                       non_manifold_vertices != 0,
                                                       vertices_on_edges != 0,
                                                       duplicate_triangles != 0,
                                                       opposite_triangles != 0,
                                                       internal_walls != 0,
                                                       crossing_shells != 0,
                                                       close_vertices != 0};
  const auto at = std::ranges::find(surface_defects, defect);
  if (at == surface_defects.end())
    throw InvalidShape("SurfaceFaults::has: there is no defect '" + std::string(defect) +
                       "'; take one of surface_defects");
  return found[static_cast<std::size_t>(at - surface_defects.begin())];
}

bool SurfaceFaults::any() const {
  return std::ranges::any_of(surface_defects, [this](std::string_view defect) { return has(defect); });
}

SurfaceFaults find_faults(const TriangleMesh& mesh, const MeshEdges& edges, const MeshStatistics& statistics,
                          const FaultOptions& options) {
  SurfaceFaults c;
  c.closed = c.oriented = true;
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    const auto forward = static_cast<std::size_t>(std::ranges::count(uses, true, &EdgeUse::forward));
    const std::size_t backward = uses.size() - forward;
    if (uses.size() % 2 != 0) c.closed = false;
    if (std::max(forward, backward) - std::min(forward, backward) > 1) c.oriented = false;
  }
  const Bvh bvh = build_bvh(mesh, {.execution = options.execution});
  Shells found = find_shells(mesh, edges, bvh, {.execution = options.execution, .progress = options.progress});
  c.met = found.met;
  c.open_edges = statistics.boundary_edges;
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() == 1 && !found.shells[found.shell_of[uses[0].face]].wall) ++c.open_edges_of_others;
  }
  c.shells = std::move(found.shells);
  const auto count = [&](auto is) { return static_cast<std::uint64_t>(std::ranges::count_if(c.shells, is)); };
  c.closed_shells = count(&Shell::closed);
  c.inside_out_shells = count(&Shell::inside_out);
  c.crossing_shells = count(&Shell::crosses);
  c.internal_walls = count(&Shell::wall);
  c.degenerate = statistics.zero_area_faces;
  c.triangles = statistics.faces;
  c.repeated_vertices = statistics.repeated_vertices;
  c.non_manifold_edges = statistics.non_manifold_edges;
  c.non_manifold_vertices = non_manifold_vertices(mesh, edges).size();
  const std::vector<VertexOnEdge> on_edges = vertices_on_edges(edges, bvh, options.execution);
  for (std::size_t i = 0; i < on_edges.size(); ++i)
    c.vertices_on_edges += i == 0 || on_edges[i].vertex != on_edges[i - 1].vertex;
  const std::vector<CoincidentTriangle> coincident = coincident_triangles_of(mesh, statistics);
  c.opposite_triangles =
      static_cast<std::uint64_t>(std::ranges::count(coincident, true, &CoincidentTriangle::opposite));
  c.duplicate_triangles = coincident.size() - c.opposite_triangles;
  c.nearer_than = options.nearer_than;
  if (c.nearer_than) c.close_vertices = close_vertices(mesh, *c.nearer_than, options.execution).size();
  return c;
}

SurfaceFaults find_faults(const TriangleMesh& mesh, const FaultOptions& options) {
  const MeshEdges edges = find_edges(mesh);
  return find_faults(mesh, edges, mesh_statistics(mesh, edges), options);
}

}  // namespace plumb
