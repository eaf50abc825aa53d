#include "plumb/surface/file/write_mesh.hpp"

#include <cmath>
#include <numeric>

#include "plumb/surface/planar/triangulate.hpp"
#include "surface/file/mesh_failure.hpp"
#include "surface/file/print_mesh.hpp"
#include "surface/file/whole_file.hpp"

namespace plumb {
namespace {

using surface::fail_at_file;

void require_sound(const PolygonMesh& mesh) {
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Point3& p = mesh.vertices[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw NonFinite("mesh: vertex " + std::to_string(v) + " is not finite, expected real numbers; mend the mesh");
  }
  bool sound = !mesh.first.empty() && mesh.first.front() == 0 && mesh.first.back() == mesh.corners.size();
  for (std::size_t f = 0; f + 1 < mesh.first.size() && sound; ++f)
    sound = mesh.first[f] < mesh.first[f + 1] && mesh.first[f + 1] - mesh.first[f] >= 3;
  if (!sound)
    throw Error(
        "mesh: `first` does not divide the corners, expected 0, then a number at least 3 larger for each face, "
        "the last being the number of corners");
  for (std::size_t k = 0; k < mesh.corners.size(); ++k)
    if (mesh.corners[k] >= mesh.vertices.size())
      throw Error("mesh: corner " + std::to_string(k) + " names vertex " + std::to_string(mesh.corners[k]) +
                  ", expected less than " + std::to_string(mesh.vertices.size()) + ", the number of vertices");
}

MeshFormat format_to_write(const std::string& path, const WriteOptions& options) {
  const auto format = options.format ? options.format : format_by_extension(path);
  if (!format)
    fail_at_file(MeshFileProblem::unknown_format, path,
                 "the name does not tell the format, expected .obj, .off, .stl or .ply; rename it or give the format");
  return *format;
}

}  // namespace

PolygonMesh to_polygons(const TriangleMesh& mesh) {
  PolygonMesh polygons;
  polygons.vertices = mesh.vertices;
  polygons.corners.reserve(3 * mesh.triangles.size());
  polygons.first.reserve(mesh.triangles.size() + 1);
  for (const auto& t : mesh.triangles) {
    polygons.corners.insert(polygons.corners.end(), t.begin(), t.end());
    polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  }
  return polygons;
}

std::string format_mesh(const PolygonMesh& mesh, MeshFormat format, std::optional<MeshEncoding> encoding,
                        std::string_view name) {
  if (format == MeshFormat::three_mf || format == MeshFormat::gltf)
    fail_at_file(MeshFileProblem::unsupported, name,
                 std::string(name_of(format)) + " is read, not written, expected OBJ, OFF, STL or PLY; choose one");
  require_sound(mesh);
  const auto used =
      encoding.value_or(format == MeshFormat::ply ? MeshEncoding::binary_little_endian : MeshEncoding::ascii);
  if (format == MeshFormat::ply) return surface::print_ply(mesh, used);
  if (format == MeshFormat::stl && used == MeshEncoding::binary_little_endian)
    return surface::print_binary_stl(triangulate(mesh), name);
  if (used != MeshEncoding::ascii)
    fail_at_file(MeshFileProblem::unsupported, name,
                 std::string(name_of(format)) + " has no " + std::string(name_of(used)) +
                     " form, expected ASCII (STL: or binary little endian); choose that or PLY");
  if (format == MeshFormat::stl) return surface::print_ascii_stl(triangulate(mesh));
  return format == MeshFormat::obj ? surface::print_obj(mesh) : surface::print_off(mesh);
}

std::string format_mesh(const PolygonMesh& mesh, const std::string& path, const WriteOptions& options) {
  return format_mesh(mesh, format_to_write(path, options), options.encoding, path);
}

void write_mesh(const std::string& path, const PolygonMesh& mesh, const WriteOptions& options) {
  surface::write_whole_file(path, format_mesh(mesh, path, options));
}

void write_mesh(const std::string& path, const TriangleMesh& mesh, const WriteOptions& options) {
  write_mesh(path, to_polygons(mesh), options);
}

}  // namespace plumb
