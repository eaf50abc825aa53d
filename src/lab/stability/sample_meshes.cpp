#include "lab/stability/sample_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "lab/trial/location_tests.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "tool/mesh/flange.hpp"

namespace plumb::lab::stability {
namespace {

TriangleMesh moved(TriangleMesh mesh, double scale, double by) {
  for (Point3& p : mesh.vertices) p = {scale * p.x + by, scale * p.y + by, scale * p.z + by};
  return mesh;
}

}  // namespace

TriangleMesh ball_mesh(int times) {
  TriangleMesh mesh{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, {}};
  for (const auto& [a, b, c] : trial::octahedron_faces) {
    mesh.triangles.push_back(
        {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
  }
  for (int i = 0; i < times; ++i) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, fresh] = middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
      if (fresh) {
        const Point3 p = mesh.vertices[a], q = mesh.vertices[b];
        const double x = p.x + q.x, y = p.y + q.y, z = p.z + q.z, length = std::sqrt(x * x + y * y + z * z);
        mesh.vertices.push_back({x / length, y / length, z / length});
      }
      return at->second;
    };
    std::vector<TriangleMesh::Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

std::vector<NamedMesh> generated_meshes(bool quick) {
  return {
      {"ball", "a ball of triangles", [quick] { return ball_mesh(quick ? 3 : 5); }},
      {"flange", "a machined part with flats and bores, every coordinate rounded",
       [] { return moved(tool::build_flange().mesh, 0.1, 1.3); }},
      {"far-flange", "the same part a million units from the origin",
       [] { return moved(tool::build_flange().mesh, 0.1, 1e6 + 1.3); }},
  };
}

std::vector<NamedMesh> real_meshes(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (format_by_extension(entry.path())) files.push_back(entry.path());
  }
  if (files.empty()) throw Error(folder + ": no mesh in this folder; there should be files .obj, .off, .ply or .stl");
  std::ranges::sort(files);
  std::vector<NamedMesh> meshes;
  for (const std::filesystem::path& file : files) {
    const std::string name = file.filename().string();
    const TriangleMesh mesh = read_mesh(file);
    if (mesh.triangles.empty()) throw Error(file.string() + ": a mesh without faces; take it out of the folder");
    meshes.push_back({name, "the mesh of " + name, [mesh] { return mesh; }});
  }
  return meshes;
}

}  // namespace plumb::lab::stability
