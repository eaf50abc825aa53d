#include "plumb/surface/file/read_mesh.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <string>

#include "plumb/surface/planar/triangulate.hpp"
#include "surface/file/foreign_formats.hpp"
#include "surface/file/gunzip.hpp"
#include "surface/file/mesh_failure.hpp"
#include "surface/file/mesh_parsers.hpp"
#include "surface/file/text_lines.hpp"

namespace plumb {
namespace {

using surface::fail_at_file;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

std::string read_file(const std::filesystem::path& path) {
  const std::string name = path.string();
  if (name.find('\0') != std::string::npos)  // the system would open what is named before it
    fail_at_file(MeshFileProblem::missing, surface::in_quotes(name),
                 "there is no such file, for a name holds no zero byte; check the path");
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
namespace {

/// The entry of this sort, one more.
PassedOver& counted(std::vector<PassedOver>& all, std::string_view what) {
  auto at = std::find_if(all.begin(), all.end(), [what](const PassedOver& p) { return p.what == what; });
  if (at == all.end()) at = all.insert(all.end(), PassedOver{std::string(what), 0, {}, {}, {}});
  ++at->count;
  return *at;
}

}  // namespace

void Parse::pass_over_in_line(std::string_view what, std::uint64_t line, std::string_view found) {
  if (options.strictness == Strictness::strict)
    fail_at_line(MeshFileProblem::syntax, file, line,
                 "found " + in_quotes(found) + ", expected a file without " + std::string(what) +
                     "; mend or delete it, or read less strictly");
  PassedOver& entry = counted(report.passed_over, what);
  if (entry.count != 1) return;
  entry.line = line;
  entry.first = found.empty() ? "the file ends" : in_quotes(found);
}

void Parse::pass_over_at_byte(std::string_view what, std::uint64_t byte, const std::string& found) {
  PassedOver& entry = counted(report.passed_over, what);
  if (entry.count != 1) return;
  entry.byte = byte;
  entry.first = found;
}

std::uint64_t unpacked_limit(std::uint64_t packed, const ReadOptions& options) {
  constexpr std::uint64_t free_bytes = std::uint64_t{16} << 20, most = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t ratio = std::max<std::uint64_t>(1, options.most_ratio);
  const std::uint64_t by_ratio = packed > (most - free_bytes) / ratio ? most : free_bytes + ratio * packed;
  return std::min(options.most_bytes, by_ratio);
}

}  // namespace surface

namespace {

void parse_format(surface::Parse& parse) {
  switch (parse.report.format) {
    case MeshFormat::obj:
      return surface::parse_obj(parse);
    case MeshFormat::off:
      return surface::parse_off(parse);
    case MeshFormat::stl:
      return surface::parse_stl(parse);
    case MeshFormat::ply:
      return surface::parse_ply(parse);
    case MeshFormat::three_mf:
      return surface::parse_3mf(parse);
    case MeshFormat::gltf:
      return surface::parse_gltf(parse);
  }
}

// What is as its format has it is read as ever; only what is refused then is looked at with leniency.
void parse_leniently(surface::Parse& parse) {
  const surface::Parse fresh = parse;
  try {
    parse.options.strictness = Strictness::usual;
    parse_format(parse);
  } catch (const MeshFileError&) {
    parse = fresh;
    if (parse.parts != nullptr) *parse.parts = {};
    parse_format(parse);
  }
}

// `packed` is the size of the file that the bytes came from.
PolygonMesh parse_as(std::string_view bytes, MeshFormat format, std::string_view name, LoadReport* report,
                     const ReadOptions& options, std::uint64_t packed, const std::filesystem::path& folder,
                     surface::FileParts* parts = nullptr) {
  require_bytes(bytes, name);
  surface::Parse parse{.bytes = bytes, .file = name};
  parse.limit = surface::unpacked_limit(packed, options);
  parse.folder = folder;
  parse.read = packed;
  parse.options = options;
  parse.parts = parts;
  parse.report.format = format;
  if (parse.lenient())
    parse_leniently(parse);
  else
    parse_format(parse);
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
  if (parts != nullptr && !parts->unread.empty()) return std::move(mesh);
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
                      const ReadOptions& options, const std::filesystem::path& folder,
                      surface::FileParts* parts = nullptr) {
  const std::string name = path.string();
  require_bytes(bytes, name);
  const std::uint64_t size = bytes.size();
  if (!surface::is_gzip(bytes))
    return parse_as(bytes, format_of(path, bytes, name), name, report, options, size, folder, parts);
  const std::string unpacked = surface::gunzip(bytes, name, surface::unpacked_limit(size, options));
  require_bytes(unpacked, name);
  const auto within = surface::lower_case(path.extension().string()) == ".gz" ? path.stem() : path;
  PolygonMesh mesh = parse_as(unpacked, format_of(within, unpacked, name), name, report, options, size, folder, parts);
  if (report) report->packed_bytes = size;
  return mesh;
}

}  // namespace

PolygonMesh parse_mesh(std::string_view bytes, MeshFormat format, std::string_view name, LoadReport* report,
                       const ReadOptions& options) {
  return parse_as(bytes, format, name, report, options, bytes.size(), {});
}

PolygonMesh parse_mesh(std::string_view bytes, const std::string& name, LoadReport* report,
                       const ReadOptions& options) {
  return parse_any(bytes, name, report, options, {});
}

PolygonMesh surface::read_parts(const std::string& path, FileParts& parts, LoadReport* report,
                                const ReadOptions& options) {
  const std::filesystem::path file(path);
  return parse_any(read_file(file), file, report, options, file.has_parent_path() ? file.parent_path() : ".", &parts);
}

PolygonMesh surface::parse_parts(std::string_view bytes, const std::string& name, FileParts& parts, LoadReport* report,
                                 const ReadOptions& options) {
  return parse_any(bytes, name, report, options, {}, &parts);
}

PolygonMesh read_polygon_mesh(const std::string& path, LoadReport* report, const ReadOptions& options) {
  const std::filesystem::path file(path);
  return parse_any(read_file(file), file, report, options, file.has_parent_path() ? file.parent_path() : ".");
}

TriangleMesh read_mesh(const std::string& path, LoadReport* report, const ReadOptions& options) {
  return triangulate(read_polygon_mesh(path, report, options), report ? &report->fans : nullptr);
}

}  // namespace plumb
