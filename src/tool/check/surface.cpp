#include "tool/check/surface.hpp"

#include <fmt/format.h>

#include "tool/terminal/number_text.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {
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

}  // namespace plumb::tool
