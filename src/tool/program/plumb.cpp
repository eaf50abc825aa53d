#include <fmt/format.h>

#include <array>
#include <utility>

#include "tool/manual/help_text.hpp"
#include "tool/program/program.hpp"

namespace plumb::tool {
namespace {

std::vector<Command> commands_of(CLI::App& app) {
  return {
      bounds_command(app),   check_command(app),   fuzz_command(app),   plan_command(app),    sign_command(app),
      proof_command(app),    doctor_command(app),  ray_command(app),    bvh_command(app),     intersect_command(app),
      distance_command(app), convex_command(app),  inside_command(app), nearest_command(app), pairs_command(app),
      section_command(app),  convert_command(app), repair_command(app), closest_command(app), hausdorff_command(app),
      csg_command(app),      resolve_command(app), split_command(app),  parts_command(app),   boolean_command(app),
      replay_command(app),   bsp_command(app),     clash_command(app),  collect_command(app)};
}

std::string instead_of(const std::string& word) {
  constexpr std::string_view
      laboratory = "that is a command of plumb-lab, the laboratory (docs/charts.md)",
      solids =
          "'plumb boolean OPERATION A B -o OUT' unites, intersects and subtracts solids; 'plumb intersect "
          "A B' finds where two meshes cross, 'plumb section' cuts one by planes",
      offsets =
          "meshes are not offset or thickened yet; 'plumb distance' says how far two are apart, "
          "the library asks about all within a radius of a figure (Fat, docs/closest.md)",
      repair =
          "'plumb repair' mends meshes: it welds, divides edges, fills holes, turns what is inside "
          "out, and leaves out what is one too many",
      simpler =
          "meshes are not simplified or made anew yet; 'plumb repair' mends them, with no more "
          "change than that takes",
      parts =
          "'plumb parts' parts solids into convex ones or covers them with hulls; of polygons "
          "in the plane the library does that (docs/triangulation.md)",
      scenes =
          "scenes are not played yet; 'plumb clash' says which parts of an assembly are in each other's way, 'plumb "
          "pairs' finds boxes that overlap, the library when moving figures meet",
      clashes = "'plumb clash' says which parts of an assembly touch, overlap, pierce or enclose one another",
      hulls =
          "'plumb convex' answers for the convex hulls of meshes; the library makes hulls "
          "(convex_hull, docs/hulls.md)",
      python =
          "'import plumb' is the Python module (docs/python.md); what is asked of meshes and "
          "tables here is answered as JSON too (--json)";

  // What words begin with that mean the same: "booleans", "boolean-union", "unions".
  constexpr std::array<std::pair<std::string_view, std::string_view>, 47> stems{{
      {"chart", laboratory},    {"stability", laboratory}, {"vectors", laboratory}, {"boolean", solids},
      {"union", solids},        {"unite", solids},         {"difference", solids},  {"subtract", solids},
      {"intersection", solids}, {"csg", solids},           {"arrange", solids},     {"carve", solids},
      {"offset", offsets},      {"thicken", offsets},      {"inflate", offsets},    {"minkowski", offsets},
      {"repair", repair},       {"mend", repair},          {"fix", repair},         {"heal", repair},
      {"clean", repair},        {"weld", repair},          {"stitch", repair},      {"fill", repair},
      {"simplif", simpler},     {"decimate", simpler},     {"remesh", simpler},     {"reorient", repair},
      {"convexdecomp", parts},  {"convexpart", parts},     {"convexpiece", parts},  {"decompos", parts},
      {"partition", parts},     {"vhacd", parts},          {"coacd", parts},        {"acd", parts},
      {"scene", scenes},        {"simulat", scenes},       {"physics", scenes},     {"colli", scenes},
      {"interfer", clashes},    {"motion", scenes},        {"ccd", scenes},         {"hull", hulls},
      {"convexhull", hulls},    {"python", python},        {"quickhull", hulls},
  }};
  std::string plain;
  for (const char c : word) {
    if (c != '-' && c != '_' && c != ' ') plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  for (const auto& [stem, text] : stems) {
    if (plain.starts_with(stem)) return std::string(text);
  }
  return "";
}

}  // namespace

ProgramFacts plumb_facts() { return {"plumb", program_manual, commands_of, instead_of}; }

}  // namespace plumb::tool
