#include "tool/check/surface.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plumb/figure/measures/measures.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {
namespace {

PairCount pairs_that_meet(const TriangleMesh& mesh, const std::string& name) {
  constexpr std::uint64_t steps = 1000;
  Progress bar(name, steps);
  PairOptions asked;
  if (bar.shown()) {
    asked.progress = [&bar](double share) {
      bar.advance(static_cast<std::uint64_t>(share * steps) - bar.done());
      return true;
    };
  }
  return count_self_intersecting_pairs(build_bvh(mesh), asked);
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

}  // namespace

bool SurfaceCheck::has(std::string_view defect) const {
  const std::array<bool, surface_defects.size()> found{!closed, !oriented, inside_out, meets_itself(), degenerate != 0};
  return found[static_cast<std::size_t>(std::ranges::find(surface_defects, defect) - surface_defects.begin())];
}

SurfaceCheck check_surface(const TriangleMesh& mesh, const MeshEdges& edges, const MeshStatistics& statistics,
                           const std::string& name) {
  SurfaceCheck c;
  c.closed = c.oriented = true;
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    const auto forward = static_cast<std::size_t>(std::ranges::count(uses, true, &EdgeUse::forward));
    const std::size_t backward = uses.size() - forward;
    if (uses.size() % 2 != 0) c.closed = false;
    if (std::max(forward, backward) - std::min(forward, backward) > 1) c.oriented = false;
  }
  c.inside_out = c.closed && c.oriented && signed_volume(mesh) < 0;
  c.met = pairs_that_meet(mesh, name);
  c.degenerate = statistics.zero_area_faces;
  c.triangles = statistics.faces;
  c.repeated_vertices = statistics.repeated_vertices;
  return c;
}

std::string surface_verdict(const SurfaceCheck& c) {
  if (c.triangles == 0) return "none: there are no triangles";
  return fmt::format("{}, {}, {}, {}", c.closed ? "closed" : "not closed",
                     !c.oriented    ? "not oriented"
                     : c.inside_out ? "oriented inward"
                                    : "oriented",
                     meeting(c), c.degenerate == 0 ? "free of degenerate triangles" : "with degenerate triangles");
}

}  // namespace plumb::tool
