#include "plumb/surface/read_mesh.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "mesh_failure.hpp"
#include "mesh_parsers.hpp"
#include "plumb/surface/triangulate.hpp"

namespace plumb {
namespace {

using surface::fail_at_file;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string read_file(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (status.type() == std::filesystem::file_type::not_found)
    fail_at_file(MeshFileProblem::missing, name, "there is no such file; check the path");
  if (std::filesystem::is_directory(status))
    fail_at_file(MeshFileProblem::unreadable, name, "is a directory, expected a mesh file; name a file in it");
  if (std::filesystem::is_block_file(status) || (std::filesystem::is_character_file(status) && path != "/dev/stdin"))
    fail_at_file(MeshFileProblem::unreadable, name, "is a device, expected a mesh file or a pipe; name a file");
  const auto refuse = [&](int error) {
    fail_at_file(MeshFileProblem::unreadable, name,
                 std::string("cannot be read: ") + std::strerror(error) + "; check its permissions and its disk");
  };
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) refuse(errno);
  std::string bytes;
  std::array<char, 1 << 16> chunk;
  while (const std::size_t got = std::fread(chunk.data(), 1, chunk.size(), file.get())) bytes.append(chunk.data(), got);
  if (std::ferror(file.get())) refuse(errno);
  return bytes;
}

void require_bytes(std::string_view bytes, std::string_view name) {
  if (bytes.empty())
    fail_at_file(MeshFileProblem::empty_file, name, "the file is empty (0 bytes), expected a mesh; export it again");
}

}  // namespace

PolygonMesh parse_mesh(std::string_view bytes, MeshFormat format, std::string_view name, LoadReport* report) {
  require_bytes(bytes, name);
  surface::Parse parse{.bytes = bytes, .file = name};
  parse.report.format = format;
  switch (format) {
    case MeshFormat::obj:
      surface::parse_obj(parse);
      break;
    case MeshFormat::off:
      surface::parse_off(parse);
      break;
    case MeshFormat::stl:
      surface::parse_stl(parse);
      break;
    case MeshFormat::ply:
      surface::parse_ply(parse);
      break;
  }
  PolygonMesh& mesh = parse.mesh;
  LoadReport& said = parse.report;
  said.bytes = bytes.size();
  said.vertices = mesh.vertices.size();
  said.faces = mesh.first.size() - 1;
  for (std::size_t f = 0; f < said.faces; ++f) said.polygons += mesh.first[f + 1] - mesh.first[f] > 3;
  said.decimals = parse.decimals.decimals();
  said.inexact_decimals = parse.decimals.inexact();
  said.largest_move = parse.decimals.largest_move();
  if (report) *report = said;
  const std::string kind(name_of(format));
  if (mesh.vertices.empty())
    fail_at_file(
        MeshFileProblem::empty_mesh, name,
        "the mesh is empty: no vertex was found, expected " + kind + " with vertices and faces; export it again");
  if (said.faces == 0)
    fail_at_file(MeshFileProblem::empty_mesh, name,
                 "the mesh is empty: " + std::to_string(said.vertices) +
                     " vertices but no face of three corners or more" +
                     ", expected a surface, not a point cloud or wires; export it with faces");
  return std::move(mesh);
}

PolygonMesh read_polygon_mesh(const std::filesystem::path& path, LoadReport* report) {
  const std::string bytes = read_file(path), name = path.string();
  require_bytes(bytes, name);
  const auto format = recognize_format(path, bytes);
  if (!format)
    fail_at_file(
        MeshFileProblem::unknown_format, name,
        "neither the name nor the content tells the format, expected .obj, .off, .stl or .ply; rename or convert it");
  return parse_mesh(bytes, *format, name, report);
}

TriangleMesh read_mesh(const std::filesystem::path& path, LoadReport* report) {
  return triangulate(read_polygon_mesh(path, report), report ? &report->fans : nullptr);
}

}  // namespace plumb
