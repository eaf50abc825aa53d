#include "tool/split/command.hpp"

#include <fmt/format.h>

#include <utility>

#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/surface/solid/boolean.hpp"
#include "plumb/surface/solid/split.hpp"
#include "tool/section/plane_words.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {
namespace {

SplitSolid parts_by_mesh(const std::vector<TriangleMesh>& meshes, Pieces pieces) {
  const Arrangement all = arrange(meshes, pieces);
  SplitSolid parts{solid_where(all, [](const auto& w) { return w[0] > 0 && w[1] <= 0; }),
                   solid_where(all, [](const auto& w) { return w[0] > 0 && w[1] > 0; })};
  if (pieces == Pieces::of_polygons) parts = {merge_pieces(parts.above), merge_pieces(parts.below)};
  return parts;
}

NamedPlane the_plane(const std::string& words) {
  std::vector<NamedPlane> planes = planes_of(words);
  if (planes.size() != 1)
    throw Error(fmt::format("split: '{}' is {} planes; one is taken at a time", printable(words), planes.size()));
  return std::move(planes.front());
}

}  // namespace

int run_split(const SplitOptions& options) {
  if (options.meshes.words.size() != 1) throw Error("split: takes one mesh; 'plumb split --help' explains");
  if (options.plane.has_value() == options.by.has_value())
    throw Error("split: by what is not said, or twice; add '--plane z=1' or '--by MESH'");
  std::vector<std::string> files{options.meshes.words.front()};
  if (options.by) files.push_back(*options.by);
  OutputFiles outputs(files);
  promise_solid("split", options, outputs);
  promise_one("--other", options.other, options, outputs);
  const ThreadLimit limit(options.threads);
  std::optional<NamedPlane> plane;
  if (options.plane) plane = the_plane(*options.plane);
  MeshArguments asking = options.meshes;
  asking.words = files;
  std::vector<AskedMesh> asked = read_asked_meshes(asking, outputs);
  const bool says = !outputs.on_standard_output();
  const Style style(stdout);
  nlohmann::json said = report_on("plumb split", asked);
  said["plane_words"] = plane ? nlohmann::json(plane->name) : nlohmann::json();
  std::vector<TriangleMesh> meshes;
  for (AskedMesh& mesh : asked) {
    if (says) say(mesh_line(mesh, style) + "\n");
    complain_of_inside_out(mesh, "");
    meshes.push_back(std::move(mesh.mesh));
  }
  if (says) flush_output();
  std::vector<BooleanReport> parts;
  try {
    Progress bar("split", 3);
    bar.note("cutting");
    bar.advance();
    SplitSolid made = plane ? split(resolve(meshes[0], WindingRule::positive, options.pieces()), plane->plane)
                            : parts_by_mesh(meshes, options.pieces());
    bar.note("rounding");
    bar.advance();
    parts.push_back(finished(options, plane ? "above" : "outside", made.above, "--output", *options.output, outputs));
    if (options.other)
      parts.push_back(finished(options, plane ? "below" : "inside", made.below, "--other", *options.other, outputs));
  } catch (const UnbalancedEdge& e) {
    const std::string& file = files[e.face.mesh];
    complain(fmt::format("{}: {}; run 'plumb repair {} -o MENDED' first", printable(name_of_input(file)),
                         unbalanced_text(e), printable(file)));
    return 2;
  }
  bool are_sound = true;
  said["split_parts"] = nlohmann::json::array();
  for (const BooleanReport& part : parts) {
    if (says) say(boolean_text(part, style));
    said["split_parts"].push_back(boolean_json(part));
    are_sound = are_sound && part.result.sound;
  }
  if (options.json) outputs.write("--json", json_text(said));
  outputs.keep();
  return are_sound ? 0 : 1;
}

}  // namespace plumb::tool
