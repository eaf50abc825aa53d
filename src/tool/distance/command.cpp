#include "tool/distance/command.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "plumb/arith/error.hpp"
#include "plumb/query/overlap/overlap.hpp"
#include "tool/terminal/json_text.hpp"
#include "tool/terminal/origin.hpp"
#include "tool/terminal/output_files.hpp"

namespace plumb::tool {
namespace {

/// One end of the shortest way.
struct NearEnd {
  std::uint32_t triangle;
  Feature feature;
  Point3 point;
  std::vector<std::uint32_t> vertices;  // of the feature, as the mesh numbers them
};

NearEnd near_end(const TriangleMesh& mesh, std::uint32_t triangle, Feature feature, const Point3& point) {
  return {triangle, feature, point, vertices_of(mesh, triangle, feature)};
}

std::array<NearEnd, 2> near_ends(const DistanceReport& report) {
  const auto& [a, b, closest] = *report.nearest;
  return {near_end(report.meshes[0].mesh, a, closest.feature_a, closest.on_a),
          near_end(report.meshes[1].mesh, b, closest.feature_b, closest.on_b)};
}

bool they_meet(const TriangleMesh& a, const TriangleMesh& b, const ClosestTriangles& nearest) {
  const auto triangle = [](const TriangleMesh& mesh, std::uint32_t number) {
    const auto& [p, q, r] = mesh.triangles[number];
    return Triangle3{mesh.vertices[p], mesh.vertices[q], mesh.vertices[r]};
  };
  return relate(triangle(a, nearest.a), triangle(b, nearest.b)) != Relation::disjoint;
}

}  // namespace

std::string distance_text(const DistanceReport& report, const Style& style) {
  std::string text;
  for (const AskedMesh& mesh : report.meshes) text += mesh_line(mesh, style) + "\n";
  if (!report.nearest) return text + "no distance: a mesh has no triangles\n";
  const double distance = report.nearest->closest.distance;
  text += style.bold(fmt::format("distance {}", distance));
  text += report.meet ? ": they meet\n" : distance == 0 ? ": it rounds to that, and they do not meet\n" : "\n";
  text += style.dim(fmt::format("  {:>10} {:<6}  {}\n", "triangle", "at", "point"));
  char side = 'a';
  for (const NearEnd& end : near_ends(report)) {
    const auto& [x, y, z] = end.point;
    text += fmt::format("{} {:>10} {:<6}  {} {} {}\n", side++, end.triangle, feature_word(end.feature), x, y, z);
  }
  return text;
}

nlohmann::json distance_json(const DistanceReport& report) {
  using nlohmann::json;
  json ends = json::array(), said = report_on("plumb distance", report.meshes);
  said.update({{"distance", nullptr}, {"meet", nullptr}});
  if (!report.nearest) return said;
  for (const NearEnd& end : near_ends(report)) {
    ends.push_back({{"triangle", end.triangle},
                    {"feature", feature_word(end.feature)},
                    {"vertex_numbers", end.vertices},
                    {"point", {end.point.x, end.point.y, end.point.z}}});
  }
  said["distance"] = report.nearest->closest.distance;
  said["meet"] = report.meet;
  said["nearest"] = std::move(ends);
  return said;
}

int run_distance(const DistanceOptions& options) {
  OutputFiles outputs(options.meshes.words);
  outputs.promise("--json", options.json);
  promise_obj(outputs, options.obj);
  if (options.meshes.words.size() != 2)
    throw Error("distance: two meshes are needed; 'plumb distance --help' explains");
  DistanceReport report;
  report.meshes = read_asked_meshes(options.meshes, outputs);
  report.nearest =
      closest_triangles(build_bvh(report.meshes[0].mesh), build_bvh(report.meshes[1].mesh), {.first = true});
  if (report.nearest) report.meet = they_meet(report.meshes[0].mesh, report.meshes[1].mesh, *report.nearest);
  if (!outputs.on_standard_output()) say(distance_text(report, Style(stdout)));
  if (options.json) outputs.write("--json", json_text(distance_json(report)));
  if (options.obj.path) {
    std::vector<TriangleGroup> groups;
    if (report.nearest) {
      groups.push_back({"a", &report.meshes[0].mesh, {report.nearest->a}});
      groups.push_back({"b", &report.meshes[1].mesh, {report.nearest->b}});
    }
    outputs.write("--obj", triangles_obj("plumb distance: the triangles of " + report.meshes[0].name + " (a) and " +
                                             report.meshes[1].name + " (b) that are nearest to one another",
                                         groups));
  }
  outputs.keep();
  return 0;
}

}  // namespace plumb::tool
