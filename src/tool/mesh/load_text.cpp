#include "tool/mesh/load_text.hpp"

#include <fmt/format.h>

#include "tool/terminal/number_text.hpp"

namespace plumb::tool {

std::string load_text(const LoadReport& l, bool triangulated) {
  const std::string packed = l.packed_bytes == 0 ? "" : fmt::format(" (gzip: {})", grouped(l.packed_bytes));
  std::string s = fmt::format("  file        {}, {}, {}{}; {}, {}\n", name_of(l.format), name_of(l.encoding),
                              plural(l.bytes, "byte", "bytes"), packed, plural(l.vertices, "vertex", "vertices"),
                              plural(l.faces, "face", "faces"));
  if (l.polygons != 0)
    s += fmt::format("              {} of more than three corners{}{}\n", plural(l.polygons, "face", "faces"),
                     triangulated ? ", triangulated" : "",
                     l.fans != 0 ? fmt::format(" ({} as fans: not simple polygons)", grouped(l.fans)) : "");
  if (l.dropped_faces != 0)
    s += fmt::format("              {} of fewer than three corners left out\n",
                     plural(l.dropped_faces, "face", "faces"));
  if (l.merged_vertices != 0)
    s += fmt::format("              {} merged with an equal point\n", plural(l.merged_vertices, "corner", "corners"));
  if (l.inexact_decimals != 0) {
    s += fmt::format("  rounding    {} of {} decimals are no doubles; the farthest moved by {:.2g}\n",
                     grouped(l.inexact_decimals), grouped(l.decimals), l.largest_move);
  }
  if (l.parts != 0)
    s += fmt::format("  parts       {}{}\n", plural(l.parts, "placed mesh", "placed meshes"),
                     l.unit.empty() ? "" : fmt::format("; the unit is the {}", l.unit));
  if (l.transformed != 0) {
    s += fmt::format("  placing     {} made by transforms, {} of them rounded, once each\n",
                     plural(l.transformed, "coordinate", "coordinates"), grouped(l.rounded));
  }
  for (const PassedOver& p : l.passed_over) s += fmt::format("  passed over {}\n", passed_over_text(p));
  return s;
}

std::string passed_over_text(const PassedOver& p) {
  const std::string where = p.line ? fmt::format("in line {}", *p.line) : fmt::format("at byte {}", p.byte.value_or(0));
  return fmt::format("{}: {}, {}{}: {}", p.what, grouped(p.count), p.count == 1 ? "" : "the first ", where, p.first);
}

}  // namespace plumb::tool
