#include "tool/boolean/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "plumb/surface/solid/boolean.hpp"
#include "surface/solid/face_pool.hpp"
#include "tool/mesh/asked_mesh.hpp"
#include "tool/mesh/writing_to.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {
namespace {

WindingRule winding_rule_of(const BooleanOptions& options) {
  return options.rule == "odd"       ? WindingRule::odd
         : options.rule == "nonzero" ? WindingRule::nonzero
                                     : WindingRule::positive;
}

ExactMesh combined(const BooleanOptions& options, std::span<const TriangleMesh> meshes) {
  const WindingRule rule = winding_rule_of(options);
  const Pieces pieces = options.merge ? Pieces::of_polygons : Pieces::of_triangles;
  if (options.operation == "union") return unite(meshes, rule, pieces);
  if (options.operation == "intersection") return intersect(meshes, rule, pieces);
  if (options.operation == "difference") return subtract(meshes, rule, pieces);
  return symmetric_difference(meshes, rule, pieces);
}

std::string corner_text(const Point3& p) { return fmt::format("({}, {}, {})", p.x, p.y, p.z); }

/// What is named twice is complained of once.
bool is_named_before(const std::vector<std::string>& files, std::size_t i) {
  return std::ranges::find(files, files[i]) - files.begin() != static_cast<std::ptrdiff_t>(i);
}

/// Every one of the meshes that bounds nothing is complained of.
void complain_of_unbalanced(const std::vector<std::string>& files, std::span<const TriangleMesh> meshes) {
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    if (is_named_before(files, m)) continue;
    try {
      surface::pool_faces(meshes.subspan(m, 1));
    } catch (const UnbalancedEdge& e) {
      complain(fmt::format("{}: {} the edge from {} to {}, of triangle {}; run 'plumb repair {} -o MENDED' first",
                           printable(name_of_input(files[m])),
                           e.is_open ? "the mesh is open at" : "triangles run against each other along",
                           corner_text(e.edge[0]), corner_text(e.edge[1]), e.face.triangle, printable(files[m])));
    }
  }
}

/// By `positive` what a mesh that is inside out encloses is outside, which is seldom meant.
void complain_of_inside_out(const BooleanOptions& options, const AskedMesh& asked) {
  if (options.rule != "positive" || !asked.closed) return;
  try {
    // The double nearest to the exact volume has its sign, or is zero.
    if (signed_volume(asked.mesh) < 0)
      complain(
          fmt::format("{}: it is wound inside out, and by '--rule positive' what it encloses is outside; 'plumb "
                      "repair' turns it, '--rule nonzero' takes it as if it were turned",
                      printable(asked.name)));
  } catch (const Error&) {  // its volume is beyond all doubles
  }
}

std::optional<double> volume_if_any(const TriangleMesh& mesh) {
  try {
    return signed_volume(mesh);
  } catch (const Error&) {
    return {};
  }
}

}  // namespace

int run_boolean(const BooleanOptions& options) {
  if (options.operation.empty())
    throw Error("boolean: an operation and two meshes are needed; 'plumb boolean --help' explains");
  if (!options.output) throw Error("boolean: where the result goes is not said; add '-o FILE'");
  const MeshInputs inputs = mesh_inputs(options.meshes);
  if (inputs.faults.empty() && inputs.files.size() < 2)
    throw Error("boolean: two meshes are needed, or more; 'plumb boolean --help' explains");
  OutputFiles outputs(inputs.files);
  // A format that cannot be written is refused before anything is read.
  format_mesh(PolygonMesh{}, *options.output, writing_to(*options.output));
  outputs.promise_mesh("--output", options.output, options.overwrite ? surface::Replacing::yes : surface::Replacing::no,
                       "give another name, or --overwrite to replace it");
  outputs.promise("--json", options.json);
  const ThreadLimit limit(options.threads);
  const bool says = !outputs.on_standard_output();
  const Style style(stdout);
  if (says)
    for (const std::string& remark : inputs.remarks) say(remark);
  std::vector<AskedMesh> asked;
  if (!each_mesh(inputs, options.meshes.reading(), [&](InputMesh input) {
        asked.push_back(asked_mesh(input.name, input.mesh, std::move(input.load), outputs));
      }))
    return 2;
  nlohmann::json said = report_on("plumb boolean", asked);
  said["passed_over"] = inputs.passed_over;
  std::vector<TriangleMesh> meshes;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (says) say(mesh_line(asked[i], style) + "\n");
    if (!is_named_before(inputs.files, i)) complain_of_inside_out(options, asked[i]);
    meshes.push_back(std::move(asked[i].mesh));
  }
  if (says) flush_output();
  BooleanReport report{options.operation, {}, {}, {}};
  try {
    Progress bar("boolean " + options.operation, 3);
    bar.note("combining");
    bar.advance();
    const ExactMesh exact = combined(options, meshes);
    bar.note("rounding");
    bar.advance();
    report.result = round(exact, {.rounds = options.rounds});
  } catch (const UnbalancedEdge&) {
    complain_of_unbalanced(inputs.files, meshes);
    return 2;
  }
  report.volume = volume_if_any(report.result.mesh);
  const bool writes = report.result.sound || options.unsound;
  if (writes) {
    report.written = *options.output;
    outputs.write("--output",
                  format_mesh(to_polygons(report.result.mesh), *options.output, writing_to(*options.output)));
  }
  if (says) say(boolean_text(report, style));
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
