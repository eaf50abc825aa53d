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

void promise_solid(const std::string& command, const SolidOptions& options, OutputFiles& outputs) {
  require_output(command, options);
  // A format that cannot be written is refused before anything is read.
  format_mesh(PolygonMesh{}, *options.output, writing_to(*options.output));
  outputs.promise_mesh("--output", options.output, options.overwrite ? surface::Replacing::yes : surface::Replacing::no,
                       "give another name, or --overwrite to replace it");
  outputs.promise("--json", options.json);
}

int conclude(const SolidOptions& options, const std::string& operation, const std::function<ExactMesh()>& combine,
             nlohmann::json said, OutputFiles& outputs) {
  const bool says = !outputs.on_standard_output();
  BooleanReport report{operation, {}, {}, {}};
  {
    Progress bar(operation, 3);
    bar.note("combining");
    bar.advance();
    const ExactMesh exact = combine();
    bar.note("rounding");
    bar.advance();
    report.result = round(exact, {.rounds = options.rounds});
  }
  report.volume = volume_if_any(report.result.mesh);
  const bool writes = report.result.sound || options.unsound;
  if (writes) {
    report.written = *options.output;
    outputs.write("--output",
                  format_mesh(to_polygons(report.result.mesh), *options.output, writing_to(*options.output)));
  }
  if (says) say(boolean_text(report, Style(stdout)));
  if (!writes)
    complain(
        "the result is not sound when it is rounded, and is not written; allow more '--rounds', or take it as it is by "
        "'--unsound'");
  said.update(boolean_json(report));
  if (options.json) outputs.write("--json", json_text(said));
  outputs.keep();
  return report.result.sound ? 0 : 1;
}

}  // namespace plumb::tool
