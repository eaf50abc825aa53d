#include "tool/boolean/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "plumb/surface/solid/boolean.hpp"
#include "surface/solid/face_pool.hpp"
#include "tool/mesh/asked_mesh.hpp"

namespace plumb::tool {
namespace {

WindingRule winding_rule_of(const BooleanOptions& options) {
  return options.rule == "odd"       ? WindingRule::odd
         : options.rule == "nonzero" ? WindingRule::nonzero
                                     : WindingRule::positive;
}

ExactMesh combined(const BooleanOptions& options, std::span<const TriangleMesh> meshes) {
  const WindingRule rule = winding_rule_of(options);
  const Pieces pieces = options.pieces();
  if (options.operation == "resolve") return resolve(meshes[0], rule, pieces);
  if (options.operation == "union") return unite(meshes, rule, pieces);
  if (options.operation == "intersection") return intersect(meshes, rule, pieces);
  if (options.operation == "difference") return subtract(meshes, rule, pieces);
  return symmetric_difference(meshes, rule, pieces);
}

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
      complain(fmt::format("{}: {}; run 'plumb repair {} -o MENDED' first", printable(name_of_input(files[m])),
                           unbalanced_text(e), printable(files[m])));
    }
  }
}

}  // namespace

int run_boolean(const BooleanOptions& options) {
  const bool resolves = options.operation == "resolve";
  const std::string command = resolves ? "resolve" : "boolean";
  if (options.operation.empty())
    throw Error("boolean: an operation and two meshes are needed; 'plumb boolean --help' explains");
  require_output(command, options);
  const MeshInputs inputs = mesh_inputs(options.meshes);
  if (inputs.faults.empty() && !resolves && inputs.files.size() < 2)
    throw Error("boolean: two meshes are needed, or more; 'plumb boolean --help' explains");
  if (inputs.faults.empty() && resolves && inputs.files.size() != 1)
    throw Error("resolve: takes one mesh; 'plumb boolean' combines several");
  OutputFiles outputs(inputs.files);
  promise_solid(command, options, outputs);
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
  nlohmann::json said = report_on("plumb " + command, asked);
  said["passed_over"] = inputs.passed_over;
  std::vector<TriangleMesh> meshes;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (says) say(mesh_line(asked[i], style) + "\n");
    if (!is_named_before(inputs.files, i) && options.rule == "positive")
      complain_of_inside_out(asked[i], ", '--rule nonzero' takes it as if it were turned");
    meshes.push_back(std::move(asked[i].mesh));
  }
  if (says) flush_output();
  try {
    return conclude(
        options, options.operation, [&] { return combined(options, meshes); }, std::move(said), outputs);
  } catch (const UnbalancedEdge&) {
    complain_of_unbalanced(inputs.files, meshes);
    return 2;
  }
}

}  // namespace plumb::tool
