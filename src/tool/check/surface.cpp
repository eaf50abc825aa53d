#include "tool/check/surface.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tool/terminal/number_text.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {
namespace {

std::string meeting(const SurfaceFaults& c) {
  if (!c.meets_itself()) return "free of self-intersections";
  std::string said = c.met.overlapping != 0 ? "self-intersecting" : "touching itself";
  if (c.met.touching != 0 && c.repeated_vertices != 0) {
    said += fmt::format(" ({} where another is: triangles that meet there share none, and touch)",
                        plural(c.repeated_vertices, "vertex lies", "vertices lie"));
  }
  return said;
}

std::string orientation(const SurfaceFaults& c) {
  if (!c.oriented) return "not oriented";
  if (!c.inside_out()) return "oriented";
  if (c.inside_out_shells == c.shells.size()) return "oriented inward";
  return fmt::format("oriented but for {}",
                     plural(c.inside_out_shells, "shell that is inside out", "shells that are inside out"));
}

bool is_faulty(const Shell& s) { return s.inside_out() || s.wall || s.crosses; }

}  // namespace

SurfaceFaults check_surface(const TriangleMesh& mesh, const MeshEdges& edges, const MeshStatistics& statistics,
                            const std::string& name, std::optional<double> nearer_than) {
  constexpr std::uint64_t steps = 1000;
  Progress bar(name, steps);
  FaultOptions asked{.nearer_than = nearer_than};
  if (bar.shown()) {
    asked.progress = [&bar](double share) {
      bar.advance(static_cast<std::uint64_t>(share * steps) - bar.done());
      return true;
    };
  }
  return find_faults(mesh, edges, statistics, asked);
}

std::string surface_verdict(const SurfaceFaults& c) {
  if (c.triangles == 0) return "none: there are no triangles";
  return fmt::format("{}{}, {}, {}, {}",
                     c.shells.size() > 1 ? plural(c.shells.size(), "shell", "shells") + ", " : std::string(),
                     c.closed ? "closed" : "not closed", orientation(c), meeting(c),
                     c.degenerate == 0 ? "free of degenerate triangles" : "with degenerate triangles");
}

std::string turning_advice(const SurfaceFaults& c) {
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

std::vector<std::size_t> shown_shells(const SurfaceFaults& c, std::size_t most) {
  std::vector<std::size_t> shown;
  for (const bool faulty : {true, false})
    for (std::size_t i = 0; i < c.shells.size() && shown.size() < most; ++i)
      if (is_faulty(c.shells[i]) == faulty) shown.push_back(i);
  std::ranges::sort(shown);
  return shown;
}

}  // namespace plumb::tool
