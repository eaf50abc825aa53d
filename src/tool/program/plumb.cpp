#include <fmt/format.h>

#include <array>
#include <utility>

#include "tool/manual/help_text.hpp"
#include "tool/program/program.hpp"

namespace plumb::tool {
namespace {

std::vector<Command> commands_of(CLI::App& app) {
  return {bounds_command(app),   check_command(app),  fuzz_command(app),   plan_command(app),    sign_command(app),
          proof_command(app),    doctor_command(app), ray_command(app),    bvh_command(app),     intersect_command(app),
          distance_command(app), convex_command(app), inside_command(app), nearest_command(app), pairs_command(app),
          section_command(app),  convert_command(app)};
}

std::string instead_of(const std::string& word) {
  constexpr std::string_view laboratory = "that is a command of plumb-lab, the laboratory (docs/charts.md)",
                             solids =
                                 "solids are not united, cut or intersected yet; 'plumb intersect A B' finds where "
                                 "two meshes cross, 'plumb section' cuts one by planes",
                             repair =
                                 "meshes are not mended yet; 'plumb check' says what is wrong with them, 'plumb "
                                 "intersect --obj' shows where they cross themselves",
                             parts =
                                 "meshes are not parted into convex pieces yet; 'plumb convex' answers for their "
                                 "convex hulls, 'plumb bvh' builds trees over them as they are",
                             scenes =
                                 "scenes are not played yet; 'plumb pairs' finds boxes that overlap, 'plumb "
                                 "distance' how far two meshes are apart, the library when moving figures meet",
                             hulls =
                                 "'plumb convex' answers for the convex hulls of meshes; the library makes hulls "
                                 "(convex_hull, docs/hulls.md)";
  constexpr std::array<std::pair<std::string_view, std::string_view>, 28> known{{
      {"chart", laboratory},    {"stability", laboratory}, {"vectors", laboratory}, {"boolean", solids},
      {"union", solids},        {"unite", solids},         {"difference", solids},  {"subtract", solids},
      {"intersection", solids}, {"csg", solids},           {"arrange", solids},     {"repair", repair},
      {"mend", repair},         {"fix", repair},           {"heal", repair},        {"weld", repair},
      {"fill", repair},         {"simplify", repair},      {"remesh", repair},      {"decompose", parts},
      {"parts", parts},         {"vhacd", parts},          {"scene", scenes},       {"simulate", scenes},
      {"collide", scenes},      {"motion", scenes},        {"hull", hulls},         {"convex-hull", hulls},
  }};
  for (const auto& [name, text] : known) {
    if (word == name) return std::string(text);
  }
  return {};
}

}  // namespace

ProgramFacts plumb_facts() { return {"plumb", program_manual, commands_of, instead_of}; }

}  // namespace plumb::tool
