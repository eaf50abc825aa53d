#include <fmt/format.h>

#include <utility>

#include "plumb/arith/error.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "tool/boolean/command.hpp"
#include "tool/mesh/writing_to.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {
namespace {

std::string corner_text(const Point3& p) { return fmt::format("({}, {}, {})", p.x, p.y, p.z); }

std::optional<double> volume_if_any(const TriangleMesh& mesh) {
  try {
    return signed_volume(mesh);
  } catch (const Error&) {  // it is not closed, or beyond all doubles
    return {};
  }
}

}  // namespace

std::string unbalanced_text(const UnbalancedEdge& found) {
  return fmt::format("{} the edge from {} to {}, of triangle {}",
                     found.is_open ? "the mesh is open at" : "triangles run against each other along",
                     corner_text(found.edge[0]), corner_text(found.edge[1]), found.face.triangle);
}

void complain_of_inside_out(const AskedMesh& asked, const std::string& mend) {
  // The double nearest to the exact volume has its sign, or is zero.
  if (asked.closed && volume_if_any(asked.mesh).value_or(0) < 0)
    complain(
        fmt::format("{}: it is wound inside out, and by '--rule positive' what it encloses is outside; 'plumb "
                    "repair' turns it{}",
                    printable(asked.name), mend));
}

void require_output(const std::string& command, const SolidOptions& options) {
  if (!options.output) throw Error(command + ": where the result goes is not said; add '-o FILE'");
}

void promise_one(const std::string& option, const std::optional<std::string>& path, const SolidOptions& options,
                 OutputFiles& outputs) {
  if (!path) return;
  format_mesh(PolygonMesh{}, *path, writing_to(*path));
  outputs.promise_mesh(option, path, options.overwrite ? surface::Replacing::yes : surface::Replacing::no,
                       "give another name, or --overwrite to replace it");
}

void promise_solid(const std::string& command, const SolidOptions& options, OutputFiles& outputs) {
  require_output(command, options);
  promise_one("--output", options.output, options, outputs);
  outputs.promise("--json", options.json);
}

BooleanReport finished(const SolidOptions& options, const std::string& operation, const ExactMesh& exact,
                       const std::string& option, const std::string& path, OutputFiles& outputs) {
  BooleanReport report{operation, round(exact, {.rounds = options.rounds}), {}, {}};
  report.volume = volume_if_any(report.result.mesh);
  if (report.result.sound || options.unsound) {
    report.written = path;
    outputs.write(option, format_mesh(to_polygons(report.result.mesh), path, writing_to(path)));
  } else {
    complain(
        "the result is not sound when it is rounded, and is not written; allow more '--rounds', or take it as it is by "
        "'--unsound'");
  }
  return report;
}

int conclude(const SolidOptions& options, const std::string& operation, const std::function<ExactMesh()>& combine,
             nlohmann::json said, OutputFiles& outputs) {
  std::optional<BooleanReport> report;
  {
    Progress bar(operation, 3);
    bar.note("combining");
    bar.advance();
    const ExactMesh exact = combine();
    bar.note("rounding");
    bar.advance();
    report = finished(options, operation, exact, "--output", *options.output, outputs);
  }
  if (!outputs.on_standard_output()) say(boolean_text(*report, Style(stdout)));
  said.update(boolean_json(*report));
  if (options.json) outputs.write("--json", json_text(said));
  outputs.keep();
  return report->result.sound ? 0 : 1;
}

}  // namespace plumb::tool
