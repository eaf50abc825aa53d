#include "tool/hausdorff/command.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "plumb/certify/thread_limit.hpp"
#include "tool/terminal/decimal_range.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/origin.hpp"
#include "tool/terminal/output_files.hpp"

namespace plumb::tool {
namespace {

double tolerance_of(const std::string& words, const char* option) {
  const double tolerance = read_decimal(words, option).value;
  if (tolerance < 0)
    throw Error(fmt::format("{}: {} is negative; give a tolerance of zero or more", option, printable(words)));
  return tolerance;
}

HausdorffOptions asked_of(const HausdorffCommandOptions& options) {
  HausdorffOptions asked;
  if (options.absolute) {
    asked.absolute = tolerance_of(*options.absolute, "--absolute");
    asked.relative = 0;
  }
  if (options.relative) asked.relative = tolerance_of(*options.relative, "--relative");
  return asked;
}

}  // namespace

std::string hausdorff_text(const HausdorffReport& report, const Style& style) {
  const HausdorffDistance& d = report.distance;
  std::string text;
  for (const AskedMesh& mesh : report.meshes) text += mesh_line(mesh, style) + "\n";
  const std::string which =
      report.one_way ? fmt::format("{} from {}", report.far().name, report.from().name) : "the farther of both ways";
  text += style.bold(d.least == d.most ? fmt::format("distance {}", d.least)
                                       : fmt::format("distance at least {}, at most {}", d.least, d.most));
  text += fmt::format(": {}\n", which);
  text += fmt::format("the farthest point, of triangle {} of {}: {} {} {}\n", d.from, report.far().name, d.point.x,
                      d.point.y, d.point.z);
  text += fmt::format("nearest to it is triangle {} of {}\n", d.to, report.from().name);
  if (!d.is_within)
    text += style.yellow("The interval is wider than was asked for: doubles, or the pieces, did not suffice.\n");
  return text;
}

nlohmann::json hausdorff_json(const HausdorffReport& report) {
  const HausdorffDistance& d = report.distance;
  nlohmann::json said = report_on("plumb hausdorff", report.meshes);
  said.update(
      {{"one_way", report.one_way},
       {"least", d.least},
       {"most", d.most},
       {"within_tolerance", d.is_within},
       {"farthest", {{"mesh", report.far().name}, {"triangle", d.from}, {"point", {d.point.x, d.point.y, d.point.z}}}},
       {"nearest_to_it", {{"mesh", report.from().name}, {"triangle", d.to}}}});
  return said;
}

int run_hausdorff(const HausdorffCommandOptions& options) {
  OutputFiles outputs(options.meshes.words);
  outputs.promise("--json", options.json);
  promise_obj(outputs, options.obj);
  if (options.meshes.words.size() != 2)
    throw Error("hausdorff: two meshes are needed; 'plumb hausdorff --help' explains");
  const HausdorffOptions asked = asked_of(options);
  const ThreadLimit limit(options.threads);
  HausdorffReport report;
  report.one_way = options.one_way;
  report.meshes = read_asked_meshes(options.meshes, outputs);
  const Bvh a = build_bvh(report.meshes[0].mesh), b = build_bvh(report.meshes[1].mesh);
  report.distance = options.one_way ? hausdorff_from(a, b, asked) : hausdorff_distance(a, b, asked);
  if (!outputs.on_standard_output()) say(hausdorff_text(report, Style(stdout)));
  if (options.json) outputs.write("--json", json_text(hausdorff_json(report)));
  if (options.obj.path) {
    const TriangleGroup groups[] = {{"farthest", &report.far().mesh, {report.distance.from}},
                                    {"nearest", &report.from().mesh, {report.distance.to}}};
    outputs.write("--obj", triangles_obj("plumb hausdorff: the triangle of " + report.far().name +
                                             " that has the farthest point, and the one of " + report.from().name +
                                             " nearest to it",
                                         groups));
  }
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool
