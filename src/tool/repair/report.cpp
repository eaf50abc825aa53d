#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "tool/check/surface.hpp"
#include "tool/mesh/load_text.hpp"
#include "tool/repair/command.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

using nlohmann::json;

/// How often each kind of change was made, and how far the farthest moved.
struct Tallied {
  std::uint64_t times = 0;
  double farthest = 0;
};

std::array<Tallied, change_kinds> tally(const Repaired& done) {
  std::array<Tallied, change_kinds> all{};
  for (const RepairChange& c : done.changes) {
    Tallied& t = all[static_cast<std::size_t>(c.kind)];
    ++t.times;
    t.farthest = std::max(t.farthest, c.distance);
  }
  return all;
}

std::string lines_of(const std::array<Tallied, change_kinds>& all, bool left, std::string_view title) {
  std::string s;
  for (std::size_t k = 0; k < change_kinds; ++k) {
    const auto kind = static_cast<ChangeKind>(k);
    if (all[k].times == 0 || is_left(kind) != left) continue;
    s += fmt::format("  {:<10}  {}: {}{}\n", s.empty() ? title : "", text_of(kind), grouped(all[k].times),
                     all[k].farthest != 0 ? fmt::format(", at most {} away", all[k].farthest) : "");
  }
  return s;
}

std::vector<std::string> defects_of(const SurfaceFaults& faults) {
  std::vector<std::string> names;
  for (const std::string_view defect : surface_defects)
    if (faults.has(defect)) names.emplace_back(defect);
  return names;
}

}  // namespace

std::string repair_text(const MendedMesh& m, const Style& style) {
  const auto all = tally(m.done);
  std::string s = style.bold(printable(m.name)) + "\n";
  s += fmt::format("  was         {}\n", surface_verdict(m.before));
  const std::string changed = lines_of(all, false, "changed");
  s += changed.empty() ? "  changed     nothing\n" : changed;
  s += lines_of(all, true, "left");
  s += fmt::format("  is          {}\n", surface_verdict(m.done.faults));
  if (m.written) s += fmt::format("  written     {}\n", printable(*m.written));
  return s;
}

json repair_json(const MendedMesh& m) {
  json j{{"mesh", m.name},
         {"vertices", m.vertices},
         {"triangles", m.triangles},
         {"closed", m.before.closed},
         {"defects_before", defects_of(m.before)},
         {"surface_before", surface_verdict(m.before)},
         {"mended_vertices", m.done.mesh.vertices.size()},
         {"mended_triangles", m.done.mesh.triangles.size()},
         {"defects_after", defects_of(m.done.faults)},
         {"surface_after", surface_verdict(m.done.faults)},
         {"written", m.written ? json(*m.written) : json()},
         {"changes", json::array()},
         {"places", json::array()}};
  const auto all = tally(m.done);
  for (std::size_t k = 0; k < change_kinds; ++k) {
    const auto kind = static_cast<ChangeKind>(k);
    if (all[k].times != 0)
      j["changes"].push_back({{"change", text_of(kind)},
                              {"left_as_it_was", is_left(kind)},
                              {"count", all[k].times},
                              {"distance", all[k].farthest}});
  }
  for (const RepairChange& c : m.done.changes) {
    if (j["places"].size() == most_places) break;
    j["places"].push_back({{"change", text_of(c.kind)},
                           {"repair_step", name_of(c.step)},
                           {"point", {c.place.x, c.place.y, c.place.z}},
                           {"count", c.count},
                           {"distance", c.distance}});
  }
  j["more_places"] = m.done.changes.size() - j["places"].size();
  return j;
}

}  // namespace plumb::tool
