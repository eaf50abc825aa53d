#include "tool/csg/command.hpp"

#include <fmt/format.h>

#include <utility>

#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "tool/csg/tree.hpp"
#include "tool/terminal/number_text.hpp"

namespace plumb::tool {
namespace {

std::string scene_text(const CsgScene& scene, const std::string& name, std::size_t leaves, const Style& style) {
  std::string text;
  for (const AskedMesh& mesh : scene.imported) text += mesh_line(mesh, style) + "\n";
  text += style.bold(printable(name)) + fmt::format(": {} {}", leaves, leaves == 1 ? "solid" : "solids");
  if (scene.placed.inexact != 0)
    text += fmt::format(", {} of {} coordinates rounded where matrices put them", grouped(scene.placed.inexact),
                        grouped(scene.placed.coordinates));
  return text + "\n";
}

}  // namespace

int run_csg(const CsgOptions& options) {
  if (options.text.empty()) throw Error("csg: the text of a solid is needed; 'plumb csg --help' explains");
  OutputFiles outputs({options.text});
  promise_solid("csg", options, outputs);
  const ThreadLimit limit(options.threads);
  const std::string name = name_of_input(options.text);
  CsgScene scene = scene_of(parse_csg(bytes_of_input(options.text, std::uint64_t{1} << 30), name), name,
                            options.meshes.reading(), outputs);
  const std::size_t leaves = scene.tree ? scene.tree->leaf_count() : 0;
  if (!outputs.on_standard_output()) {
    say(scene_text(scene, name, leaves, Style(stdout)));
    flush_output();
  }
  nlohmann::json said = report_on("plumb csg", scene.imported);
  said["csg_text"] = name;
  said["solids"] = leaves;
  said["placed_coordinates"] = scene.placed.coordinates;
  said["rounded_coordinates"] = scene.placed.inexact;
  return conclude(
      options, "csg", [&] { return scene.tree ? evaluate(*scene.tree, options.pieces()) : ExactMesh{}; },
      std::move(said), outputs);
}

}  // namespace plumb::tool
