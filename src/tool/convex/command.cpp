#include "tool/convex/command.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/polyhedron.hpp"
#include "plumb/query/certificate/verify.hpp"
#include "tool/terminal/json_text.hpp"

namespace plumb::tool {
namespace {

std::optional<std::string> flaw_of_convexity(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return "it has no faces";
  try {
    static_cast<void>(convex_polyhedron(mesh));
    return {};
  } catch (const InvalidShape& e) {
    const std::string_view text = e.what(), function = "convex_polyhedron: ";
    return std::string(text.substr(text.starts_with(function) ? function.size() : 0));
  }
}

}  // namespace

HullOfMesh::HullOfMesh(AskedMesh mesh) : asked(std::move(mesh)) {
  const std::vector<Point3>& vertices = asked.mesh.vertices;
  if (vertices.empty()) throw Error(fmt::format("convex: {} has no vertices, and nothing has no hull", asked.name));
  hull = convex_hull(vertices);
  for (const std::uint32_t v : hull.vertices) corners.push_back(vertices[v]);
  if (is_solid()) solid = convex_polyhedron(hull, vertices);
  why = flaw_of_convexity(asked.mesh);
}

ConvexReport convex_report(std::vector<AskedMesh> meshes) {
  ConvexReport report;
  for (AskedMesh& mesh : meshes) report.hulls.emplace_back(std::move(mesh));
  with_bodies(report, [&](const auto& a, const auto& b) {
    report.proof = relate_with_proof(a, b);
    if (const ProofVerdict verdict = verify(report.proof, a, b); !verdict)
      throw Error("convex: the proof does not hold, which is a fault of this program: " + verdict.flaw);
    report.nearest = gjk(a, b, {.history = &report.steps, .pair = WhichPair::first});
    if (report.proof.claim == Claim::disjoint) return;
    report.penetration = penetration(a, b);
    report.is_parted = report.penetration->depth == 0 && exact_penetration(a, b)->core_square.sign() == Sign::zero;
  });
  return report;
}

int run_convex(const ConvexOptions& options) {
  OutputFiles outputs(options.meshes.words);
  outputs.promise("--json", options.json);
  outputs.promise("--certificate", options.certificate);
  if (options.meshes.words.size() != 2) throw Error("convex: two meshes are needed; 'plumb convex --help' explains");
  if (options.history) require_report_folder(*options.history, "convex", {"bodies.obj", "step-001.obj", "index.html"});
  const ConvexReport report = convex_report(read_asked_meshes(options.meshes, outputs));
  if (!outputs.on_standard_output()) say(convex_text(report, Style(stdout)));
  if (options.json) outputs.write("--json", json_text(convex_json(report)));
  if (options.certificate) outputs.write("--certificate", convex_certificate(report));
  if (!options.history) {
    outputs.keep();
  } else {
    write_report(*options.history, "convex", convex_history(report), outputs.keep_streams());
  }
  return 0;
}

}  // namespace plumb::tool
