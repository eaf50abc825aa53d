#include "tool/mesh/asked_mesh.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "plumb/query/ray/parity.hpp"
#include "plumb/surface/planar/triangulate.hpp"
#include "tool/terminal/origin.hpp"

namespace plumb::tool {

AskedMesh asked_mesh(const std::string& name, const PolygonMesh& polygons, LoadReport load,
                     const OutputFiles& outputs) {
  AskedMesh asked{name, std::move(load), {}, false};
  asked.mesh = triangulate(polygons, &asked.load.fans);
  asked.closed = !asked.mesh.triangles.empty() && is_closed(asked.mesh);
  outputs.require_not_read(asked.load.files_beside);
  return asked;
}

std::vector<AskedMesh> read_asked_meshes(const MeshArguments& meshes, const OutputFiles& outputs) {
  require_input_once(meshes.words);
  std::vector<AskedMesh> all;
  for (const std::string& file : meshes.words) {
    LoadReport load;
    const PolygonMesh polygons = read_input(file, &load, meshes.reading());
    all.push_back(asked_mesh(name_of_input(file), polygons, std::move(load), outputs));
  }
  return all;
}

std::string mesh_line(const AskedMesh& asked, const Style& style) {
  return style.bold(printable(asked.name)) + fmt::format(": {} vertices, {} triangles, {}", asked.mesh.vertices.size(),
                                                         asked.mesh.triangles.size(),
                                                         asked.closed ? "closed" : "not closed");
}

nlohmann::json mesh_json(const AskedMesh& asked) {
  return {{"mesh", asked.name},
          {"vertices", asked.mesh.vertices.size()},
          {"triangles", asked.mesh.triangles.size()},
          {"closed", asked.closed}};
}

nlohmann::json report_on(const std::string& program, std::span<const AskedMesh> meshes) {
  nlohmann::json report = origin_json(program);
  nlohmann::json& all = report["meshes"] = nlohmann::json::array();
  for (const AskedMesh& mesh : meshes) all.push_back(mesh_json(mesh));
  return report;
}

std::vector<std::uint32_t> vertices_of(const TriangleMesh& mesh, std::uint32_t triangle, Feature feature) {
  const auto& corners = mesh.triangles[triangle];
  if (feature.kind == FeatureKind::vertex) return {corners[feature.index]};
  if (feature.kind == FeatureKind::edge) return {corners[feature.index], corners[(feature.index + 1) % 3]};
  return {corners.begin(), corners.end()};
}

std::string_view feature_word(Feature feature) {
  return feature.kind == FeatureKind::vertex ? "vertex" : feature.kind == FeatureKind::edge ? "edge" : "face";
}

}  // namespace plumb::tool
