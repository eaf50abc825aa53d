#include "tool/mesh/triangles_obj.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <unordered_map>

#include "plumb/arith/error.hpp"
#include "plumb/surface/file/mesh_file.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {

std::vector<std::uint32_t> distinct(std::vector<std::uint32_t> triangles) {
  std::ranges::sort(triangles);
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return triangles;
}

std::string triangles_obj(std::string_view about, std::span<const TriangleGroup> groups) {
  std::string text = fmt::format("# {}\n", printable(about)), faces;
  const auto into = std::back_inserter(text);
  std::size_t vertices = 0;  // of all groups
  for (const TriangleGroup& group : groups) {
    if (group.triangles.empty()) continue;
    fmt::format_to(into, "o {}\n", group.name);
    std::unordered_map<std::uint32_t, std::size_t> number_of;
    faces.clear();
    for (const std::uint32_t triangle : group.triangles) {
      fmt::format_to(std::back_inserter(faces), "# {}\nf", triangle);
      for (const std::uint32_t corner : group.mesh->triangles[triangle]) {
        const auto [at, is_new] = number_of.try_emplace(corner, vertices + 1);
        if (is_new) {
          const Point3& p = group.mesh->vertices[corner];
          fmt::format_to(into, "v {} {} {}\n", p.x, p.y, p.z);  // the shortest decimals that name the doubles
          ++vertices;
        }
        fmt::format_to(std::back_inserter(faces), " {}", at->second);
      }
      faces += '\n';
    }
    text += faces;
  }
  return text;
}

void promise_obj(OutputFiles& outputs, const ObjOutput& obj) {
  if (obj.path && format_by_extension(*obj.path).value_or(MeshFormat::obj) != MeshFormat::obj)
    throw Error(
        fmt::format("--obj writes OBJ, and {} is the name of another format; give another name", printable(*obj.path)));
  outputs.promise_mesh("--obj", obj.path, obj.overwrite ? surface::Replacing::yes : surface::Replacing::no,
                       "give another name, or --overwrite to replace it");
}

}  // namespace plumb::tool
