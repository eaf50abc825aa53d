#include "tool/closest/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "space/bvh/parts.hpp"
#include "tool/mesh/asked_tree.hpp"
#include "tool/terminal/decimal_list.hpp"
#include "tool/terminal/decimal_range.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/number_text.hpp"
#include "tool/terminal/origin.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/progress.hpp"

namespace plumb::tool {
namespace {

constexpr std::size_t block = 64;  // points between two looks at the progress

double radius_of(const std::string& words) {
  const double radius = read_decimal(words, "--within").value;
  if (radius < 0) throw Error(fmt::format("--within: {} is negative; give a radius of zero or more", printable(words)));
  return radius;
}

ClosestReport closest_report(const ClosestCommandOptions& options, const OutputFiles& outputs) {
  ClosestReport report;
  if (options.within) report.radius = radius_of(*options.within);
  for (const std::string& words : options.points)
    report.points.push_back(read_named_row(words, "--point " + words, point_shape));
  MeshArguments mesh = options.files;
  if (mesh.words.size() == 2) {
    for (NamedRow& p : read_named_rows(mesh.words[1], mesh.reading(), point_shape))
      report.points.push_back(std::move(p));
    mesh.words.pop_back();
  }
  report.mesh = std::move(read_asked_meshes(mesh, outputs).front());
  const Bvh bvh = asked_tree(report.mesh, options.tree);
  const double most = report.radius.value_or(std::numeric_limits<double>::infinity());
  report.found.resize(report.points.size());
  Progress bar("closest", report.points.size());
  space::for_blocks(Execution::parallel, report.points.size(), block,
                    [&](std::size_t, std::size_t from, std::size_t to) {
                      for (std::size_t i = from; i < to; ++i)
                        report.found[i] = closest_on_mesh(bvh, point_of(report.points[i]), most);
                      bar.advance(to - from);
                    });
  return report;
}

std::vector<std::uint32_t> nearest_of(const ClosestReport& report) {
  std::vector<std::uint32_t> triangles;
  for (const auto& found : report.found) {
    if (found) triangles.push_back(found->triangle);
  }
  return distinct(std::move(triangles));
}

}  // namespace

std::string closest_text(const ClosestReport& report, bool all, const Style& style) {
  const std::size_t many = report.points.size(), shown = all ? many : std::min(many, ClosestReport::listed);
  std::size_t widest = 5, inexact = 0, beyond = 0;
  for (std::size_t i = 0; i < many; ++i) {
    if (i < shown) widest = std::max(widest, report.points[i].name.size());
    inexact += !report.points[i].exact;
    beyond += !report.found[i];
  }
  std::string text = mesh_line(report.mesh, style) + fmt::format("; {}\n", plural(many, "point", "points"));
  text += style.dim(
      fmt::format("{:<{}}  {:>22} {:>10} {:<6}  {}\n", "point", widest, "distance", "triangle", "at", "nearest point"));
  for (std::size_t i = 0; i < shown; ++i) {
    if (const auto& found = report.found[i]) {
      text +=
          fmt::format("{:<{}}  {:>22} {:>10} {:<6}  {} {} {}\n", report.points[i].name, widest, found->distance,
                      found->triangle, feature_word(found->feature), found->point.x, found->point.y, found->point.z);
    } else {
      text += fmt::format("{:<{}}  {:>22}\n", report.points[i].name, widest, "-");
    }
  }
  if (shown < many) text += fmt::format("and {} more; --all lists them\n", grouped(many - shown));
  if (report.radius) {
    text += fmt::format("{} of {} points are farther from the mesh than {}.\n", grouped(beyond), grouped(many),
                        *report.radius);
  }
  return text + inexact_remark(inexact, many, "points");
}

nlohmann::json closest_json(const ClosestReport& report) {
  using nlohmann::json;
  json places = json::array();
  for (std::size_t i = 0; i < report.points.size(); ++i) {
    const auto& [name, numbers, exact] = report.points[i];
    json place{{"name", name}, {"asked_at", numbers}, {"exact", exact}, {"distance", nullptr}};
    if (const auto& found = report.found[i]) {
      place.update({{"distance", found->distance},
                    {"triangle", found->triangle},
                    {"feature", feature_word(found->feature)},
                    {"vertex_numbers", vertices_of(report.mesh.mesh, found->triangle, found->feature)},
                    {"point", {found->point.x, found->point.y, found->point.z}}});
    }
    places.push_back(std::move(place));
  }
  json said = report_on("plumb closest", {&report.mesh, 1});
  said["within"] = report.radius ? json(*report.radius) : json();
  said["closest"] = std::move(places);
  return said;
}

int run_closest(const ClosestCommandOptions& options) {
  const std::vector<std::string>& files = options.files.words;
  std::vector<std::string> read = files;
  if (options.tree) read.push_back(*options.tree);
  require_input_once(read);
  OutputFiles outputs(read);
  outputs.promise("--json", options.json);
  promise_obj(outputs, options.obj);
  if (files.empty() || files.size() > 2)
    throw Error("closest: one MESH is needed, and at most one file of points; 'plumb closest --help' explains");
  if (options.points.empty() && files.size() == 1)
    throw Error("closest: points are needed: a file of them after the mesh, or --point, such as --point 0,0,10");
  const ThreadLimit limit(options.threads);
  const ClosestReport report = closest_report(options, outputs);
  if (!outputs.on_standard_output()) say(closest_text(report, options.all, Style(stdout)));
  if (options.json) outputs.write("--json", json_text(closest_json(report)));
  if (options.obj.path) {
    const TriangleGroup near{"nearest", &report.mesh.mesh, nearest_of(report)};
    outputs.write("--obj",
                  triangles_obj("plumb closest: the triangles of " + report.mesh.name + " that are nearest to a point",
                                {&near, 1}));
  }
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool
