#include "tool/check/surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "plumb/surface/defects.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {
namespace {

Shells shells_of(const TriangleMesh& mesh, const MeshEdges& edges, const Bvh& bvh, const std::string& name) {
  constexpr std::uint64_t steps = 1000;
  Progress bar(name, steps);
  ShellOptions asked;
  if (bar.shown()) {
    asked.progress = [&bar](double share) {
      bar.advance(static_cast<std::uint64_t>(share * steps) - bar.done());
      return true;
    };
  }
  return find_shells(mesh, edges, bvh, asked);
}

std::vector<CoincidentTriangle> coincident_triangles_of(const TriangleMesh& mesh, const MeshStatistics& statistics) {
  if (statistics.repeated_vertices != 0) return coincident_triangles(mesh);
  std::vector<std::uint32_t> own(mesh.vertices.size());  // equal to none of smaller number
  std::iota(own.begin(), own.end(), 0U);
  return coincident_triangles(mesh, own);
}

std::string meeting(const SurfaceCheck& c) {
  if (!c.meets_itself()) return "free of self-intersections";
  std::string said = c.met.overlapping != 0 ? "self-intersecting" : "touching itself";
  if (c.met.touching != 0 && c.repeated_vertices != 0) {
    said += fmt::format(" ({} where another is: triangles that meet there share none, and touch)",
                        plural(c.repeated_vertices, "vertex lies", "vertices lie"));
  }
  return said;
}

std::string orientation(const SurfaceCheck& c) {
  if (!c.oriented) return "not oriented";
  if (!c.inside_out()) return "oriented";
  if (c.inside_out_shells == c.shells.size()) return "oriented inward";
  return fmt::format("oriented but for {}",
                     plural(c.inside_out_shells, "shell that is inside out", "shells that are inside out"));
}

bool is_faulty(const Shell& s) { return s.inside_out() || s.wall || s.crosses; }

}  // namespace

bool SurfaceCheck::has(std::string_view defect) const {
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
  return found[static_cast<std::size_t>(std::ranges::find(surface_defects, defect) - surface_defects.begin())];
}

SurfaceCheck check_surface(const TriangleMesh& mesh, const MeshEdges& edges, const MeshStatistics& statistics,
                           const std::string& name, std::optional<double> nearer_than) {
  SurfaceCheck c;
  c.closed = c.oriented = true;
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    const auto forward = static_cast<std::size_t>(std::ranges::count(uses, true, &EdgeUse::forward));
    const std::size_t backward = uses.size() - forward;
    if (uses.size() % 2 != 0) c.closed = false;
    if (std::max(forward, backward) - std::min(forward, backward) > 1) c.oriented = false;
  }
  const Bvh bvh = build_bvh(mesh);
  Shells found = shells_of(mesh, edges, bvh, name);
  c.met = found.met;
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
  const std::vector<VertexOnEdge> on_edges = vertices_on_edges(edges, bvh);
  for (std::size_t i = 0; i < on_edges.size(); ++i)
    c.vertices_on_edges += i == 0 || on_edges[i].vertex != on_edges[i - 1].vertex;
  const std::vector<CoincidentTriangle> coincident = coincident_triangles_of(mesh, statistics);
  c.opposite_triangles =
      static_cast<std::uint64_t>(std::ranges::count(coincident, true, &CoincidentTriangle::opposite));
  c.duplicate_triangles = coincident.size() - c.opposite_triangles;
  c.nearer_than = nearer_than;
  if (nearer_than) c.close_vertices = close_vertices(mesh, *nearer_than).size();
  return c;
}

std::string surface_verdict(const SurfaceCheck& c) {
  if (c.triangles == 0) return "none: there are no triangles";
  return fmt::format("{}{}, {}, {}, {}",
                     c.shells.size() > 1 ? plural(c.shells.size(), "shell", "shells") + ", " : std::string(),
                     c.closed ? "closed" : "not closed", orientation(c), meeting(c),
                     c.degenerate == 0 ? "free of degenerate triangles" : "with degenerate triangles");
}

std::string turning_advice(const SurfaceCheck& c) {
  if (!c.inside_out()) return {};
  if (c.inside_out_shells == c.shells.size()) return "turn all triangles";
  constexpr std::size_t named = 5;
  std::string numbers;
  std::size_t told = 0;
  bool solids_in_solids = false;
  for (std::size_t i = 0; i < c.shells.size(); ++i) {
    if (!c.shells[i].inside_out()) continue;
    solids_in_solids = solids_in_solids || c.shells[i].depth % 2 == 1;
    if (told++ < named) numbers += fmt::format("{}{}", numbers.empty() ? " " : ", ", i);
  }
  if (told > named) numbers += fmt::format(" and {} more", grouped(told - named));
  return fmt::format("turn shell{}{} and no other{}", told == 1 ? "" : "s", numbers,
                     solids_in_solids ? ", or leave out what is a solid within a solid and no cavity" : "");
}

std::vector<std::size_t> shown_shells(const SurfaceCheck& c, std::size_t most) {
  std::vector<std::size_t> shown;
  for (const bool faulty : {true, false})
    for (std::size_t i = 0; i < c.shells.size() && shown.size() < most; ++i)
      if (is_faulty(c.shells[i]) == faulty) shown.push_back(i);
  std::ranges::sort(shown);
  return shown;
}

}  // namespace plumb::tool
