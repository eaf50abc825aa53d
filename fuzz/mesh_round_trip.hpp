// What must hold of any bytes that are given to a mesh reader.
//
// Laws: they are refused with an Error, or become a sound mesh; whatever a stricter reading takes, a laxer one reads
// alike, and a strict one passes nothing over; that mesh triangulates into n - 2 triangles a face, its
// statistics add up, and it comes back unchanged, bit for bit, through every format that can hold it.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <optional>
#include <string_view>

#include "plumb/surface.hpp"

namespace plumb::fuzz {

inline void require(bool holds, const char* what) {
  if (holds) return;
  std::cerr << "does not hold: " << what << "\n";
  std::abort();
}

inline bool same(const PolygonMesh& l, const PolygonMesh& r) {
  return l.corners == r.corners && l.first == r.first && l.vertices.size() == r.vertices.size() &&
         std::memcmp(l.vertices.data(), r.vertices.data(), l.vertices.size() * sizeof(Point3)) == 0;
}

inline void require_sound(const PolygonMesh& mesh) {
  for (const Point3& p : mesh.vertices)
    require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "coordinates are finite");
  require(mesh.first.size() > 1 && mesh.first.front() == 0 && mesh.first.back() == mesh.corners.size(), "faces divide");
  for (std::size_t f = 0; f + 1 < mesh.first.size(); ++f)
    require(mesh.first[f] + 3 <= mesh.first[f + 1], "faces have three corners or more");
  for (const std::uint32_t corner : mesh.corners) require(corner < mesh.vertices.size(), "indices are in range");
}

inline void require_consistent(const TriangleMesh& mesh) {
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t corner : t) require(corner < mesh.vertices.size(), "indices stay in range");
  const MeshEdges edges = find_edges(mesh);
  const MeshStatistics said = mesh_statistics(mesh, edges);
  require(edges.uses.size() == 3 * (said.faces - said.repeated_corners), "each face uses three edges");
  require(said.boundary_edges + said.interior_edges + said.non_manifold_edges == said.edges,
          "edges are of three kinds");
  require(interior_edges(edges).size() == said.interior_edges, "interior edges are listed");
  require(said.zero_area_faces >= said.repeated_corners, "a face that repeats a vertex has no area");
}

inline std::optional<PolygonMesh> read_as(std::string_view bytes, MeshFormat format, Strictness strictness,
                                          LoadReport& report) try {
  PolygonMesh mesh = parse_mesh(bytes, format, "fuzz", &report, {.strictness = strictness});
  require_sound(mesh);
  return mesh;
} catch (const MeshFileError& e) {
  require(std::string_view(e.what()).starts_with("fuzz:"), "an error names the file");
  return std::nullopt;
}

/// As the laxest reading has it.
inline std::optional<PolygonMesh> read_in_every_way(std::string_view bytes, MeshFormat format, LoadReport& report) {
  const auto strict = read_as(bytes, format, Strictness::strict, report);
  require(!strict || report.passed_over.empty(), "a strict reading passes nothing over");
  const auto usual = read_as(bytes, format, Strictness::usual, report);
  require(!strict || (usual && same(*strict, *usual)), "what is read strictly is read alike");
  auto lenient = read_as(bytes, format, Strictness::lenient, report);
  require(!usual || (lenient && same(*usual, *lenient)), "what is read usually is read alike");
  require(usual || !lenient || !report.passed_over.empty(), "what is forgiven is told");
  return lenient;
}

inline int read_and_return(const std::uint8_t* data, std::size_t size, MeshFormat format) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  LoadReport report;
  static_cast<void>(recognize_format("fuzz", bytes));
  const auto read = read_in_every_way(bytes, format, report);
  if (!read) return 0;
  const PolygonMesh& mesh = *read;
  require(report.inexact_decimals <= report.decimals, "no more moved than were read");
  require((report.inexact_decimals > 0) == (report.largest_move > 0), "what moved has moved by something");
  const TriangleMesh triangles = triangulate(mesh);
  require(triangles.triangles.size() == mesh.corners.size() - 2 * (mesh.first.size() - 1), "n - 2 triangles a face");
  require_consistent(triangles);

  using enum MeshEncoding;
  for (const auto encoding : {ascii, binary_little_endian, binary_big_endian})
    require(same(mesh, parse_mesh(format_mesh(mesh, MeshFormat::ply, encoding), MeshFormat::ply, "ply")),
            "PLY returns");
  require(same(mesh, parse_mesh(format_mesh(mesh, MeshFormat::obj), MeshFormat::obj, "obj")), "OBJ returns");
  require(same(mesh, parse_mesh(format_mesh(mesh, MeshFormat::off), MeshFormat::off, "off")), "OFF returns");
  // STL forgets indices, but not what it can hold: what came from it returns.
  const PolygonMesh soup = parse_mesh(format_mesh(mesh, MeshFormat::stl), MeshFormat::stl, "stl");
  require(soup.corners.size() == 3 * triangles.triangles.size(), "STL holds the triangles");
  for (std::size_t k = 0; k < soup.corners.size(); ++k)
    require(soup.vertices[soup.corners[k]] == mesh.vertices[triangles.triangles[k / 3][k % 3]], "STL holds the points");
  require(format != MeshFormat::stl || same(mesh, soup), "STL returns");
  return 0;
}

}  // namespace plumb::fuzz
