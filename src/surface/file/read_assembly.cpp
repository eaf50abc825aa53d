#include "plumb/surface/file/read_assembly.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "plumb/surface/planar/triangulate.hpp"
#include "surface/file/mesh_parsers.hpp"

namespace plumb {
namespace {

using surface::FileParts;

/// Faces of the mesh from one up to another.
struct Faces {
  std::size_t first, end;
};
struct NamedFaces {
  std::string name;
  std::vector<Faces> faces;
};

/// "bracket" of models/bracket.stl.gz.
std::string name_of_file(const std::string& path) {
  std::filesystem::path name = std::filesystem::path(path).filename();
  if (name.extension() == ".gz" || name.extension() == ".GZ") name = name.stem();
  return name.stem().string();
}

std::vector<NamedFaces> parts_in_order(const std::string& path, const FileParts& parts, std::size_t faces) {
  const bool by_objects =
      std::ranges::any_of(parts.starts, [](const FileParts::Start& s) { return s.kind == FileParts::Kind::object; });
  std::vector<NamedFaces> made{{name_of_file(path), {}}};
  std::map<std::string, std::size_t> known;  // what OBJ names again goes on
  std::size_t begun = 0, at = 0;
  const auto end_at = [&](std::size_t face) {
    if (begun < face) made[at].faces.push_back({begun, face});
    begun = face;
  };
  for (const FileParts::Start& start : parts.starts) {
    if (by_objects && start.kind == FileParts::Kind::group) continue;
    end_at(start.face);
    std::size_t next = made.size();
    if (start.kind != FileParts::Kind::placed) next = known.try_emplace(start.name, next).first->second;
    if (next == made.size()) made.push_back({start.name.empty() ? "part " + std::to_string(next) : start.name, {}});
    at = next;
  }
  end_at(faces);
  std::erase_if(made, [](const NamedFaces& p) { return p.faces.empty(); });
  return made;
}

PolygonMesh mesh_of(const PolygonMesh& all, const std::vector<Faces>& faces) {
  std::vector<std::uint32_t> used;
  PolygonMesh made;
  for (const Faces& f : faces) {
    for (std::size_t face = f.first; face < f.end; ++face) {
      made.corners.insert(made.corners.end(), all.corners.begin() + all.first[face],
                          all.corners.begin() + all.first[face + 1]);
      made.first.push_back(static_cast<std::uint32_t>(made.corners.size()));
    }
  }
  used = made.corners;
  std::ranges::sort(used);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (const std::uint32_t v : used) made.vertices.push_back(all.vertices[v]);
  for (std::uint32_t& v : made.corners)
    v = static_cast<std::uint32_t>(std::ranges::lower_bound(used, v) - used.begin());
  return made;
}

AssemblyParts divided(const PolygonMesh& all, const FileParts& parts, const std::string& path, LoadReport& load) {
  AssemblyParts made;
  for (const NamedFaces& part : parts_in_order(path, parts, all.first.size() - 1)) {
    std::uint64_t fans = 0;
    made.parts.push_back({part.name, triangulate(mesh_of(all, part.faces), &fans)});
    load.fans += fans;
  }
  for (const FileParts::Unread& part : parts.unread) made.unread.push_back({part.name, part.why});
  return made;
}

}  // namespace

AssemblyParts read_assembly(const std::string& path, LoadReport* report, const ReadOptions& options) {
  FileParts parts;
  LoadReport own;
  LoadReport& load = report != nullptr ? *report : own;
  const PolygonMesh all = surface::read_parts(path, parts, &load, options);
  return divided(all, parts, path, load);
}

AssemblyParts parse_assembly(std::string_view bytes, const std::string& name, LoadReport* report,
                             const ReadOptions& options) {
  FileParts parts;
  LoadReport own;
  LoadReport& load = report != nullptr ? *report : own;
  const PolygonMesh all = surface::parse_parts(bytes, name, parts, &load, options);
  return divided(all, parts, name, load);
}

}  // namespace plumb
