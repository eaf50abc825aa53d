#include "tool/parts/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "plumb/surface/parts/covering_parts.hpp"
#include "plumb/surface/planar/triangulate.hpp"
#include "tool/terminal/decimal_range.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/origin.hpp"
#include "tool/terminal/output_files.hpp"

namespace plumb::tool {
namespace {

double concavity_of(const std::string& words) {
  const double length = read_decimal(words, "--concavity").value;
  if (length < 0)
    throw Error(fmt::format("--concavity: {} is negative; give a length of zero or more", printable(words)));
  return length;
}

SolidPart exact_part(const ConvexPart& part) {
  return {triangulate(rounded(part)), part.solid.faces(), volume(part.solid), part.is_exact, {}, 0};
}

SolidPart covering_part(const CoveringPart& part) {
  const ConvexPolyhedron3 hull = convex_polyhedron(part.proxy.hull, part.proxy.vertices);
  SolidPart made{
      {part.proxy.vertices, {}}, part.proxy.hull.face_count(), volume(hull), true, part.share, part.concavity};
  for (std::size_t f = 0; f < part.proxy.hull.face_count(); ++f)
    triangulate_face(made.mesh.vertices, part.proxy.hull.face(f), made.mesh.triangles);
  return made;
}

PartsReport parts_report(const PartsOptions& options, const OutputFiles& outputs) {
  PartsReport report;
  report.covers = options.concavity || options.most;
  CoveringOptions asked;
  if (options.concavity) asked.concavity = concavity_of(*options.concavity);
  if (options.most) asked.most_parts = options.most;
  report.mesh = std::move(read_asked_meshes(options.meshes, outputs).front());
  const auto say_exact = [&](const ConvexParts& exact) {
    report.notches = exact.notches, report.cuts = exact.cuts, report.exact_parts = exact.parts.size();
  };
  if (report.covers) {
    const CoveringParts cover = covering_parts(report.mesh.mesh, asked);
    say_exact(cover.exact);
    for (const CoveringPart& part : cover.parts) report.parts.push_back(covering_part(part));
  } else {
    const ConvexParts exact = convex_parts(report.mesh.mesh);
    say_exact(exact);
    for (const ConvexPart& part : exact.parts) report.parts.push_back(exact_part(part));
  }
  return report;
}

std::vector<TriangleGroup> groups_of(const PartsReport& report, const std::vector<std::string>& names) {
  std::vector<TriangleGroup> groups;
  for (std::size_t i = 0; i < report.parts.size(); ++i) {
    std::vector<std::uint32_t> all(report.parts[i].mesh.triangles.size());
    for (std::uint32_t k = 0; k < all.size(); ++k) all[k] = k;
    groups.push_back({names[i], &report.parts[i].mesh, std::move(all)});
  }
  return groups;
}

}  // namespace

std::string parts_text(const PartsReport& report, bool all, const Style& style) {
  std::string text = mesh_line(report.mesh, style) + "\n";
  text += fmt::format("{}, {}: {}", plural(report.notches, "notch", "notches"), plural(report.cuts, "cut", "cuts"),
                      style.bold(plural(report.exact_parts, "convex part", "convex parts")));
  text += report.covers ? style.bold(fmt::format(", covered by {}", plural(report.parts.size(), "hull", "hulls"))) : "";
  text += style.dim(fmt::format("\n{:>8} {:>8} {:>8} {:>24}{}\n", "part", "vertices", "faces", "volume",
                                report.covers ? "  reaches beyond it by" : ""));
  const std::size_t shown = all ? report.parts.size() : std::min(report.parts.size(), PartsReport::listed);
  std::size_t moved = 0;
  for (const SolidPart& part : report.parts) moved += !part.is_exact;
  for (std::size_t i = 0; i < shown; ++i) {
    const SolidPart& part = report.parts[i];
    text += fmt::format("{:>8} {:>8} {:>8} {:>24}", i, part.mesh.vertices.size(), part.faces, part.volume);
    text += report.covers ? fmt::format("  {}\n", part.concavity) : "\n";
  }
  if (shown < report.parts.size())
    text += fmt::format("and {} more; --all lists them\n", grouped(report.parts.size() - shown));
  if (moved != 0) {
    text +=
        fmt::format("Corners of {} are no doubles; written are the nearest ones.\n", plural(moved, "part", "parts"));
  }
  return text;
}

nlohmann::json parts_json(const PartsReport& report) {
  using nlohmann::json;
  json parts = json::array();
  for (const SolidPart& part : report.parts) {
    json said{{"vertices", part.mesh.vertices.size()},
              {"triangles", part.mesh.triangles.size()},
              {"faces", part.faces},
              {"volume", part.volume},
              {"exact_corners", part.is_exact}};
    if (report.covers) said.update({{"share", part.share}, {"concavity", part.concavity}});
    parts.push_back(std::move(said));
  }
  json said = report_on("plumb parts", {&report.mesh, 1});
  said.update({{"notches", report.notches},
               {"cuts", report.cuts},
               {"convex_parts", report.exact_parts},
               {"solid_parts", std::move(parts)}});
  return said;
}

int run_parts(const PartsOptions& options) {
  OutputFiles outputs(options.meshes.words);
  outputs.promise("--json", options.json);
  promise_obj(outputs, options.obj);
  if (options.meshes.words.size() != 1) throw Error("parts: one MESH is needed; 'plumb parts --help' explains");
  const PartsReport report = parts_report(options, outputs);
  if (!outputs.on_standard_output()) say(parts_text(report, options.all, Style(stdout)));
  if (options.json) outputs.write("--json", json_text(parts_json(report)));
  if (options.obj.path) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < report.parts.size(); ++i) names.push_back(fmt::format("part-{}", i));
    outputs.write("--obj", triangles_obj("plumb parts: the " + std::string(report.covers ? "hulls" : "convex parts") +
                                             " of " + report.mesh.name,
                                         groups_of(report, names)));
  }
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool
