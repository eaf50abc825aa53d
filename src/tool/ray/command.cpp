#include "tool/ray/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "tool/mesh/asked_tree.hpp"
#include "tool/rows/named_rows.hpp"
#include "tool/terminal/decimal_list.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/origin.hpp"
#include "tool/terminal/output_files.hpp"

namespace plumb::tool {
namespace {

/// The library takes a zero direction for the point that it leaves; of what was typed or tabled it is a mistake.
NamedRay ray_of(NamedRow row, const std::string& what) {
  const std::vector<double>& x = row.values;
  if (x[3] == 0 && x[4] == 0 && x[5] == 0)
    throw Error(fmt::format("{}: the direction of {} is zero, so that it goes nowhere", what, row.name));
  return {std::move(row.name), Ray3{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}}, row.exact};
}

NamedRay segment_of(NamedRow row) {
  const std::vector<double>& x = row.values;
  return {std::move(row.name), Segment3{{x[0], x[1], x[2]}, {x[3], x[4], x[5]}}, row.exact};
}

RayReport ray_report(const RayOptions& options, const OutputFiles& outputs) {
  RayReport report;
  for (const std::string& words : options.rays)
    report.rays.push_back(ray_of(read_named_row(words, "--ray " + words, ray_shape), "--ray"));
  for (const std::string& words : options.segments)
    report.rays.push_back(segment_of(read_named_row(words, "--segment " + words, segment_shape)));
  const ReadOptions reading = options.meshes.reading();
  if (options.ray_file) {
    for (NamedRow& row : read_named_rows(*options.ray_file, reading, ray_shape))
      report.rays.push_back(ray_of(std::move(row), printable(name_of_input(*options.ray_file))));
  }
  if (options.segment_file) {
    for (NamedRow& row : read_named_rows(*options.segment_file, reading, segment_shape))
      report.rays.push_back(segment_of(std::move(row)));
  }
  report.mesh = std::move(read_asked_meshes(options.meshes, outputs).front());
  const Bvh bvh = asked_tree(report.mesh, options.tree);
  for (const NamedRay& ray : report.rays) report.hits.push_back(hits(bvh, ray.ray));
  return report;
}

/// Of each ray the first hit, or all.
std::vector<std::uint32_t> hit_triangles(const RayReport& report, bool all) {
  std::vector<std::uint32_t> triangles;
  for (const auto& hits : report.hits) {
    for (std::size_t k = 0; k < (all ? hits.size() : std::min<std::size_t>(hits.size(), 1)); ++k)
      triangles.push_back(hits[k].index);
  }
  return distinct(std::move(triangles));
}

}  // namespace

std::string ray_text(const RayReport& report, bool all, const Style& style) {
  std::size_t widest = 3, inexact = 0;
  for (const NamedRay& ray : report.rays) {
    widest = std::max(widest, ray.name.size());
    inexact += !ray.exact;
  }
  std::string text = mesh_line(report.mesh, style) +
                     fmt::format("; {} {}\n", report.rays.size(), report.rays.size() == 1 ? "ray" : "rays");
  text += style.dim(
      fmt::format("{:<{}} {:>6} {:>10} {:>14} {:<6}  {}\n", "ray", widest, "hits", "triangle", "t", "at", "point"));
  for (std::size_t i = 0; i < report.rays.size(); ++i) {
    const auto& hits = report.hits[i];
    const std::size_t shown = all ? hits.size() : std::min<std::size_t>(hits.size(), 1);
    text += fmt::format("{:<{}} {:>6}", report.rays[i].name, widest, hits.size());
    for (std::size_t k = 0; k < shown; ++k) {
      const auto& [index, hit] = hits[k];
      if (k != 0) text += fmt::format("{:<{}} {:>6}", "", widest, "");
      text += fmt::format(" {:>10} {:>14.6g} {:<6}  {:.6g} {:.6g} {:.6g}\n", index, hit.t, feature_word(hit.feature),
                          hit.point.x, hit.point.y, hit.point.z);
    }
    if (shown == 0) text += "\n";
  }
  return text + inexact_remark(inexact, report.rays.size(), "rays");
}

nlohmann::json ray_json(const RayReport& report) {
  using nlohmann::json;
  json rays = json::array();
  for (std::size_t i = 0; i < report.rays.size(); ++i) {
    const NamedRay& ray = report.rays[i];
    json hits = json::array();
    for (const auto& [index, hit] : report.hits[i]) {
      hits.push_back({{"triangle", index},
                      {"t", hit.t},
                      {"feature", feature_word(hit.feature)},
                      {"point", {hit.point.x, hit.point.y, hit.point.z}},
                      {"normal", {hit.normal.x, hit.normal.y, hit.normal.z}}});
    }
    rays.push_back({{"name", ray.name},
                    {"kind", ray.ray.kind == AnyRay::Kind::segment ? "segment" : "ray"},
                    {"exact", ray.exact},
                    {"hits", std::move(hits)}});
  }
  json said = report_on("plumb ray", {&report.mesh, 1});
  said["rays"] = std::move(rays);
  return said;
}

int run_ray(const RayOptions& options) {
  std::vector<std::string> read = options.meshes.words;
  for (const auto& file : {options.ray_file, options.segment_file, options.tree}) {
    if (file) read.push_back(*file);
  }
  require_input_once(read);
  OutputFiles outputs(read);
  outputs.promise("--json", options.json);
  promise_obj(outputs, options.obj);
  if (options.meshes.words.size() != 1) throw Error("ray: one MESH is needed; 'plumb ray --help' explains");
  if (options.rays.empty() && options.segments.empty() && !options.ray_file && !options.segment_file)
    throw Error("ray: a --ray or a --segment is needed, such as --ray 0,0,10,0,0,-1, or --rays FILE");
  const RayReport report = ray_report(options, outputs);
  if (!outputs.on_standard_output()) say(ray_text(report, options.all, Style(stdout)));
  if (options.json) outputs.write("--json", json_text(ray_json(report)));
  if (options.obj.path) {
    const TriangleGroup hit{"hit", &report.mesh.mesh, hit_triangles(report, options.all)};
    outputs.write("--obj",
                  triangles_obj("plumb ray: the triangles of " + report.mesh.name + " that are hit", {&hit, 1}));
  }
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool
