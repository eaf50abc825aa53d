#include "tool/ray/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/surface/triangulate.hpp"
#include "tool/terminal/decimal_range.hpp"
#include "tool/terminal/origin.hpp"
#include "tool/terminal/output_files.hpp"

namespace plumb::tool {
namespace {

NamedRay ray_of_words(const std::string& option, const std::string& words) {
  const std::string what = option + " " + words;
  std::vector<double> x;
  bool exact = true;
  for (std::size_t from = 0;;) {
    const std::size_t to = words.find_first_of(",;", from);
    const Decimal number = read_decimal(std::string_view(words).substr(from, to - from), what);
    x.push_back(number.value);
    exact = exact && number.exact;
    if (to == std::string::npos) break;
    from = to + 1;
  }
  if (x.size() != 6) {
    throw Error(fmt::format("{}: this has {} numbers; {} has six: {}", what, x.size(),
                            option == "--ray" ? "a ray" : "a segment",
                            option == "--ray" ? "origin and direction" : "its two ends"));
  }
  const Point3 a{x[0], x[1], x[2]};
  if (option == "--segment") return {words, Segment3{a, {x[3], x[4], x[5]}}, exact};
  return {words, Ray3{a, {x[3], x[4], x[5]}}, exact};
}

RayReport ray_report(const RayOptions& options) {
  RayReport report;
  for (const std::string& words : options.rays) report.rays.push_back(ray_of_words("--ray", words));
  for (const std::string& words : options.segments) report.rays.push_back(ray_of_words("--segment", words));
  const std::string& file = options.meshes.words.front();
  report.mesh_name = name_of_input(file);
  report.mesh = triangulate(read_input(file, &report.load, options.meshes.reading()), &report.load.fans);
  report.closed = is_closed(report.mesh);
  const Bvh bvh = build_bvh(report.mesh);
  for (const NamedRay& ray : report.rays) report.hits.push_back(ordered_hits(ray.ray, bvh));
  return report;
}

std::string_view feature_word(const Hit& hit) {
  return hit.feature.kind == FeatureKind::vertex ? "vertex" : hit.feature.kind == FeatureKind::edge ? "edge" : "face";
}

}  // namespace

std::string ray_text(const RayReport& report, bool all, const Style& style) {
  std::size_t widest = 3, inexact = 0;
  for (const NamedRay& ray : report.rays) {
    widest = std::max(widest, ray.name.size());
    inexact += !ray.exact;
  }
  std::string text = style.bold(printable(report.mesh_name)) +
                     fmt::format(": {} vertices, {} triangles, {}; {} {}\n", report.mesh.vertices.size(),
                                 report.mesh.triangles.size(), report.closed ? "closed" : "not closed",
                                 report.rays.size(), report.rays.size() == 1 ? "ray" : "rays");
  text += style.dim(
      fmt::format("{:<{}} {:>6} {:>10} {:>14} {:<6}  {}\n", "ray", widest, "hits", "triangle", "t", "at", "point"));
  for (std::size_t i = 0; i < report.rays.size(); ++i) {
    const auto& hits = report.hits[i];
    const std::size_t shown = all ? hits.size() : std::min<std::size_t>(hits.size(), 1);
    text += fmt::format("{:<{}} {:>6}", report.rays[i].name, widest, hits.size());
    for (std::size_t k = 0; k < shown; ++k) {
      const auto& [index, hit] = hits[k];
      if (k != 0) text += fmt::format("{:<{}} {:>6}", "", widest, "");
      text += fmt::format(" {:>10} {:>14.6g} {:<6}  {:.6g} {:.6g} {:.6g}\n", index, hit.t, feature_word(hit),
                          hit.point.x, hit.point.y, hit.point.z);
    }
    if (shown == 0) text += "\n";
  }
  if (inexact != 0)
    text += fmt::format("{} of {} rays are given by decimals that are no doubles; they stand for the nearest ones.\n",
                        inexact, report.rays.size());
  return text;
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
                      {"feature", feature_word(hit)},
                      {"point", {hit.point.x, hit.point.y, hit.point.z}},
                      {"normal", {hit.normal.x, hit.normal.y, hit.normal.z}}});
    }
    rays.push_back({{"name", ray.name},
                    {"kind", ray.ray.kind == AnyRay::Kind::segment ? "segment" : "ray"},
                    {"exact", ray.exact},
                    {"hits", std::move(hits)}});
  }
  json said = origin_json("plumb ray");
  said.update({{"mesh", report.mesh_name},
               {"vertices", report.mesh.vertices.size()},
               {"triangles", report.mesh.triangles.size()},
               {"closed", report.closed},
               {"rays", std::move(rays)}});
  return said;
}

int run_ray(const RayOptions& options) {
  if (options.meshes.words.size() != 1) throw Error("ray: one MESH is needed; 'plumb ray --help' explains");
  if (options.rays.empty() && options.segments.empty())
    throw Error("ray: a --ray or a --segment is needed, such as --ray 0,0,10,0,0,-1");
  OutputFiles outputs(options.meshes.words);
  outputs.promise("--json", options.json);
  const RayReport report = ray_report(options);
  outputs.require_not_read(report.load.files_beside);
  if (!outputs.on_standard_output()) say(ray_text(report, options.all, Style(stdout)));
  if (options.json) {
    // A file's name may be any bytes; JSON is UTF-8.
    outputs.write("--json", ray_json(report).dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  }
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool
