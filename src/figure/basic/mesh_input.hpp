// What are the faces of a mesh, and do they name vertices that it has?
//
// Cost: linear.
#pragma once

#include "figure/basic/chain_input.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb {

struct TriangleFaces {
  const TriangleMesh& mesh;
  static constexpr std::string_view face_name = "triangle ";

  [[nodiscard]] std::size_t size() const { return mesh.triangles.size(); }
  std::span<const std::uint32_t> operator[](std::size_t face) const { return mesh.triangles[face]; }
  [[nodiscard]] const Point3& at(std::uint32_t vertex) const { return mesh.vertices[vertex]; }
};

struct PolygonFaces {
  const PolygonMesh& mesh;
  static constexpr std::string_view face_name = "face ";

  [[nodiscard]] std::size_t size() const { return mesh.first.empty() ? 0 : mesh.first.size() - 1; }
  std::span<const std::uint32_t> operator[](std::size_t face) const {
    return std::span(mesh.corners).subspan(mesh.first[face], mesh.first[face + 1] - mesh.first[face]);
  }
  [[nodiscard]] const Point3& at(std::uint32_t vertex) const { return mesh.vertices[vertex]; }
};

inline TriangleFaces faces_of(const TriangleMesh& mesh) { return {mesh}; }
inline PolygonFaces faces_of(const PolygonMesh& mesh) { return {mesh}; }

inline PolygonMesh polygon_mesh(const TriangleMesh& mesh) {
  PolygonMesh polygons;
  polygons.vertices = mesh.vertices;
  for (const auto& t : mesh.triangles) {
    polygons.corners.insert(polygons.corners.end(), t.begin(), t.end());
    polygons.first.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  }
  return polygons;
}

[[noreturn]] inline void throw_invalid_mesh(std::string_view function, const std::string& what) {
  throw InvalidShape(std::string(function).append(": ").append(what));
}

inline void require_offsets(std::string_view, const TriangleMesh&) {}
inline void require_offsets(std::string_view function, const PolygonMesh& mesh) {
  const auto& first = mesh.first;
  if (first.empty() || first.front() != 0 || first.back() != mesh.corners.size())
    throw_invalid_mesh(function, "mesh.first does not begin with 0 and end with the number of corners");
  for (std::size_t f = 0; f + 1 < first.size(); ++f) {
    if (first[f + 1] >= first[f] && first[f + 1] - first[f] >= 3) continue;
    throw_invalid_mesh(
        function, std::string("face ").append(std::to_string(f)).append(" has fewer than three corners; leave it out"));
  }
}

/// Throws InvalidShape for a face of fewer than three corners or that names a vertex out of range, NonFinite for a
/// vertex that is no point.
template <class Mesh>
void require_mesh(std::string_view function, const Mesh& mesh) {
  require_offsets(function, mesh);
  const auto faces = faces_of(mesh);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const std::uint32_t v : faces[f]) {
      if (v < mesh.vertices.size()) continue;
      throw_invalid_mesh(function, std::string(faces.face_name)
                                       .append(std::to_string(f))
                                       .append(" names vertex ")
                                       .append(std::to_string(v))
                                       .append(", but there are ")
                                       .append(std::to_string(mesh.vertices.size()))
                                       .append(" vertices"));
    }
  }
  require_finite_points<Point3>(function, "mesh.vertices", mesh.vertices);
}

}  // namespace plumb
