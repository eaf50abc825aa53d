#include "plumb/surface/read_mesh.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <string>

#include "plumb/surface/triangulate.hpp"
#include "surface/foreign_formats.hpp"
#include "surface/gunzip.hpp"
#include "surface/mesh_failure.hpp"
#include "surface/mesh_parsers.hpp"
#include "surface/text_lines.hpp"

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

// The format of unpacked bytes; fails with the mend where it is none that is read.
MeshFormat format_of(const std::filesystem::path& path, std::string_view bytes, std::string_view name) {
  // Other formats are zip archives, too.
  const auto found = format_by_content(bytes);
  if (found && (found != MeshFormat::three_mf || !surface::foreign_by_extension(path))) return *found;
  auto foreign = surface::foreign_by_content(bytes);
  if (!foreign) {
    if (const auto named = format_by_extension(path)) return *named;
    foreign = surface::foreign_by_extension(path);
  }
  fail_at_file(
      MeshFileProblem::unknown_format, name,
      foreign.value_or("neither the name nor the content tells the format, expected .obj, .off, .stl, .ply, .3mf, "
                       ".gltf or .glb; rename or convert it"));
}

}  // namespace

namespace surface {

std::uint64_t unpacked_limit(std::uint64_t packed, const ReadOptions& options) {
  constexpr std::uint64_t free_bytes = std::uint64_t{16} << 20, most = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t ratio = std::max<std::uint64_t>(1, options.most_ratio);
  const std::uint64_t by_ratio = packed > (most - free_bytes) / ratio ? most : free_bytes + ratio * packed;
  return std::min(options.most_bytes, by_ratio);
}

}  // namespace surface

namespace {

// `packed` is the size of the file that the bytes came from.
PolygonMesh parse_as(std::string_view bytes, MeshFormat format, std::string_view name, LoadReport* report,
                     const ReadOptions& options, std::uint64_t packed, const std::filesystem::path& folder) {
  require_bytes(bytes, name);
  surface::Parse parse{.bytes = bytes, .file = name};
  parse.limit = surface::unpacked_limit(packed, options);
  parse.folder = folder;
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
    case MeshFormat::three_mf:
      surface::parse_3mf(parse);
      break;
    case MeshFormat::gltf:
      surface::parse_gltf(parse);
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
  if (said.faces == 0 && !options.points_too)
    fail_at_file(MeshFileProblem::empty_mesh, name,
                 "the mesh is empty: " + std::to_string(said.vertices) +
                     " vertices but no face of three corners or more" +
                     ", expected a surface, not a point cloud or wires; export it with faces");
  return std::move(mesh);
}

PolygonMesh parse_any(std::string_view bytes, const std::filesystem::path& path, LoadReport* report,
                      const ReadOptions& options, const std::filesystem::path& folder) {
  const std::string name = path.string();
  require_bytes(bytes, name);
  const std::uint64_t size = bytes.size();
  if (!surface::is_gzip(bytes))
    return parse_as(bytes, format_of(path, bytes, name), name, report, options, size, folder);
  const std::string unpacked = surface::gunzip(bytes, name, surface::unpacked_limit(size, options));
  require_bytes(unpacked, name);
  const auto within = surface::lower_case(path.extension().string()) == ".gz" ? path.stem() : path;
  PolygonMesh mesh = parse_as(unpacked, format_of(within, unpacked, name), name, report, options, size, folder);
  if (report) report->packed_bytes = size;
  return mesh;
}

}  // namespace

PolygonMesh parse_mesh(std::string_view bytes, MeshFormat format, std::string_view name, LoadReport* report) {
  return parse_as(bytes, format, name, report, {}, bytes.size(), {});
}

PolygonMesh parse_mesh(std::string_view bytes, const std::string& name, LoadReport* report,
                       const ReadOptions& options) {
  return parse_any(bytes, name, report, options, {});
}

PolygonMesh read_polygon_mesh(const std::string& path, LoadReport* report, const ReadOptions& options) {
  const std::filesystem::path file(path);
  return parse_any(read_file(file), file, report, options, file.has_parent_path() ? file.parent_path() : ".");
}

TriangleMesh read_mesh(const std::string& path, LoadReport* report, const ReadOptions& options) {
  return triangulate(read_polygon_mesh(path, report, options), report ? &report->fans : nullptr);
}

}  // namespace plumb
