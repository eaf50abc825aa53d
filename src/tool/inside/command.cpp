#include "tool/inside/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/space/ray/inside.hpp"
#include "tool/mesh/asked_tree.hpp"
#include "tool/terminal/decimal_list.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/origin.hpp"
#include "tool/terminal/output_files.hpp"

namespace plumb::tool {
namespace {

std::string_view location_word(Location location) {
  return location == Location::inside ? "inside" : location == Location::boundary ? "boundary" : "outside";
}

InsideReport inside_report(const InsideOptions& options, const OutputFiles& outputs) {
  InsideReport report;
  for (const std::string& words : options.points)
    report.points.push_back(read_named_row(words, "--point " + words, point_shape));
  if (options.file) {
    for (NamedRow& p : read_named_rows(*options.file, options.meshes.reading(), point_shape))
      report.points.push_back(std::move(p));
  }
  report.mesh = std::move(read_asked_meshes(options.meshes, outputs).front());
  report.oriented = is_oriented_closed(report.mesh.mesh);
  const Bvh bvh = asked_tree(report.mesh, options.tree);
  std::vector<Point3> points;
  for (const NamedRow& p : report.points) points.push_back(point_of(p));
  report.locations.resize(points.size());
  report.windings.resize(points.size());
  locate(bvh, points, report.locations);
  winding_number(bvh, points, report.windings);
  return report;
}

/// What the answers mean where the mesh bounds no solid.
std::string_view caveat(const InsideReport& report) {
  if (!report.mesh.closed)
    return "The mesh is not closed and bounds no solid: inside is where a ray along x crosses it an odd number of "
           "times.\n";
  if (!report.oriented)
    return "The mesh is closed, but not all of it is wound alike: winding numbers are what a ray along x counts.\n";
  return {};
}

}  // namespace

std::string inside_text(const InsideReport& report, const Style& style) {
  std::size_t widest = 5, inexact = 0;
  for (const NamedRow& p : report.points) {
    widest = std::max(widest, p.name.size());
    inexact += !p.exact;
  }
  std::string text =
      mesh_line(report.mesh, style) + fmt::format("; {}\n", plural(report.points.size(), "point", "points"));
  text += style.dim(fmt::format("{:<{}}  {:<8} {:>7}\n", "point", widest, "is", "winding"));
  for (std::size_t i = 0; i < report.points.size(); ++i) {
    text += fmt::format("{:<{}}  {:<8} {:>7}\n", report.points[i].name, widest, location_word(report.locations[i]),
                        report.windings[i] ? std::to_string(*report.windings[i]) : "-");
  }
  text += inexact_remark(inexact, report.points.size(), "points");
  return text + style.yellow(caveat(report));
}

nlohmann::json inside_json(const InsideReport& report) {
  using nlohmann::json;
  json points = json::array();
  for (std::size_t i = 0; i < report.points.size(); ++i) {
    const auto& [name, numbers, exact] = report.points[i];
    points.push_back({{"name", name},
                      {"point", numbers},
                      {"exact", exact},
                      {"location", location_word(report.locations[i])},
                      {"winding_number", report.windings[i] ? json(*report.windings[i]) : json()}});
  }
  json said = report_on("plumb inside", {&report.mesh, 1});
  said["oriented"] = report.oriented;
  said["points"] = std::move(points);
  return said;
}

int run_inside(const InsideOptions& options) {
  std::vector<std::string> read = options.meshes.words;
  for (const auto& file : {options.file, options.tree}) {
    if (file) read.push_back(*file);
  }
  require_input_once(read);
  OutputFiles outputs(read);
  outputs.promise("--json", options.json);
  if (options.meshes.words.size() != 1) throw Error("inside: one MESH is needed; 'plumb inside --help' explains");
  if (options.points.empty() && !options.file)
    throw Error("inside: a --point is needed, such as --point 0,0,10, or --points FILE");
  const InsideReport report = inside_report(options, outputs);
  if (!outputs.on_standard_output()) say(inside_text(report, Style(stdout)));
  if (options.json) outputs.write("--json", json_text(inside_json(report)));
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool
