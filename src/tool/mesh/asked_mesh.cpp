#include "tool/mesh/asked_mesh.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "plumb/query/ray/parity.hpp"
#include "plumb/surface/triangulate.hpp"

namespace plumb::tool {

std::vector<AskedMesh> read_asked_meshes(const MeshArguments& meshes, const OutputFiles& outputs) {
  require_input_once(meshes.words);
  std::vector<AskedMesh> all;
  for (const std::string& file : meshes.words) {
    AskedMesh& asked = all.emplace_back();
    asked.name = name_of_input(file);
    asked.mesh = triangulate(read_input(file, &asked.load, meshes.reading()), &asked.load.fans);
    asked.closed = is_closed(asked.mesh);
    outputs.require_not_read(asked.load.files_beside);
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

std::string_view feature_word(Feature feature) {
  return feature.kind == FeatureKind::vertex ? "vertex" : feature.kind == FeatureKind::edge ? "edge" : "face";
}

}  // namespace plumb::tool
