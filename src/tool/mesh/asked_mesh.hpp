// The mesh that questions are asked of: a file's triangles, and how reports begin to speak of them.
//
// Laws: (1) triangles have the numbers of the file's faces, from 0; of a file with polygons, those of the triangles
// that they are cut into, one after the other.  (2) What cannot be read throws Error, and so does standard input that
// is named twice, before anything is read.
// Source: plumb/surface/file/read_mesh.hpp.
// Cost: that of reading, and of sorting the edges.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/figure/basic/mesh.hpp"
#include "plumb/figure/containment/voronoi_region.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/terminal/output_files.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

struct AskedMesh {
  std::string name;
  LoadReport load;
  TriangleMesh mesh;
  bool closed = false;  // every edge is in an even number of triangles
};

/// Of what was read under this name; no output may replace what was read beside it.
AskedMesh asked_mesh(const std::string& name, const PolygonMesh& polygons, LoadReport load, const OutputFiles& outputs);

/// The meshes of these words, in their order; no output may replace what is read.
std::vector<AskedMesh> read_asked_meshes(const MeshArguments& meshes, const OutputFiles& outputs);

/// "part.obj: 8 vertices, 12 triangles, closed"
std::string mesh_line(const AskedMesh& asked, const Style& style);

/// mesh (its name), vertices, triangles, closed.
nlohmann::json mesh_json(const AskedMesh& asked);

/// The report of a command on meshes: what every report begins with, and `meshes`.
nlohmann::json report_on(const std::string& program, std::span<const AskedMesh> meshes);

/// The vertices of a feature of a triangle, as the mesh numbers them.
std::vector<std::uint32_t> vertices_of(const TriangleMesh& mesh, std::uint32_t triangle, Feature feature);

/// "vertex", "edge" or "face", of a triangle.
std::string_view feature_word(Feature feature);

}  // namespace plumb::tool
