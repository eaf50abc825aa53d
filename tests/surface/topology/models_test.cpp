// Meshes as people have them: each is read, its counts are those known of it, and it survives every format.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>

#include "certify/sanitized.hpp"
#include "figure/basic/solids.hpp"
#include "plumb/surface.hpp"

namespace plumb {
namespace {

struct Counts {
  std::uint64_t vertices, faces, triangles, boundary, non_manifold;
};

void expect_read_and_kept(const std::string& file, const Counts& known) {
  LoadReport report;
  const PolygonMesh mesh = read_polygon_mesh(file, &report);
  EXPECT_EQ(report.vertices, known.vertices);
  EXPECT_EQ(report.faces, known.faces);
  EXPECT_EQ(report.dropped_faces, 0U);
  std::uint64_t fans = 0;
  const TriangleMesh triangles = triangulate(mesh, &fans);
  EXPECT_EQ(triangles.triangles.size(), known.triangles);
  EXPECT_EQ(fans, 0U);
  const MeshStatistics said = mesh_statistics(triangles);
  EXPECT_EQ(said.boundary_edges, known.boundary);
  EXPECT_EQ(said.non_manifold_edges, known.non_manifold);
  EXPECT_EQ(said.inconsistent_edges, 0U);
  for (const auto format : {MeshFormat::obj, MeshFormat::off, MeshFormat::ply}) {
    const PolygonMesh back = parse_mesh(format_mesh(mesh, format), format, "x");
    EXPECT_TRUE(back.vertices == mesh.vertices && back.corners == mesh.corners && back.first == mesh.first);
  }
  const PolygonMesh stl = parse_mesh(format_mesh(mesh, MeshFormat::stl), MeshFormat::stl, "x");
  ASSERT_EQ(stl.corners.size(), 3 * known.triangles);
  EXPECT_EQ(stl.vertices.size(), said.vertices - said.repeated_vertices - said.unused_vertices);
  bool same = true;
  for (std::size_t k = 0; k < stl.corners.size(); ++k)
    same = same && stl.vertices[stl.corners[k]] == mesh.vertices[triangles.triangles[k / 3][k % 3]];
  EXPECT_TRUE(same);
}

/// Pairs of triangles, one after the other, as the quadrilaterals that they halve.
PolygonMesh squares(const TriangleMesh& mesh) {
  PolygonMesh all{mesh.vertices, {}, {0}};
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 2) {
    const auto& [a, b, c] = mesh.triangles[i];
    all.corners.insert(all.corners.end(), {a, b, c, mesh.triangles[i + 1][2]});
    all.first.push_back(static_cast<std::uint32_t>(all.corners.size()));
  }
  return all;
}

TEST(Models, GeneratedOnesAreReadAndSurviveEveryFormat) {
  const TriangleMesh ring = solids::torus(3, 1, 40, 20);
  const TriangleMesh two = solids::voxels({{0, 0, 0}, {1, 1, 0}});  // cubes that have an edge in common
  TriangleMesh holed = ring;
  holed.triangles.erase(holed.triangles.begin());
  const std::pair<PolygonMesh, Counts> meshes[] = {
      {to_polygons(ring), {800, 1600, 1600, 0, 0}},
      {squares(ring), {800, 800, 1600, 0, 0}},
      {to_polygons(holed), {800, 1599, 1599, 3, 0}},
      {to_polygons(solids::turned(solids::hollow_torus(3, 1, 30, 20))), {1200, 2400, 2400, 0, 0}},
      {squares(solids::pillars(10)), {800, 600, 1200, 0, 0}},
      {squares(two), {14, 12, 24, 0, 1}}};
  const std::string start =
      std::filesystem::temp_directory_path() / ("plumb_models_test_" + std::to_string(::getpid()));
  for (const auto& [mesh, known] : meshes) {
    for (const char* const ending : {".obj", ".off", ".ply"}) {
      SCOPED_TRACE(std::to_string(known.faces) + " faces, " + ending);
      write_mesh(start + ending, mesh);
      expect_read_and_kept(start + ending, known);
      std::filesystem::remove(start + ending);
    }
  }
}

struct Model {
  const char* file;
  Counts counts;
};

// Counts as other tools tell them; igea and horse are closed, so twice the vertices less four faces.
constexpr Model kModels[] = {
    {"beetle.obj", {1148, 2053, 2053, 296, 47}},    {"cheburashka.obj", {6669, 13334, 13334, 0, 0}},
    {"cow.obj", {2903, 5804, 5804, 0, 0}},          {"fandisk.obj", {6475, 12946, 12946, 0, 0}},
    {"horse.ply", {48485, 96966, 96966, 0, 0}},     {"igea.ply", {134345, 268686, 268686, 0, 0}},
    {"nefertiti.obj", {49971, 99938, 99938, 0, 0}}, {"rocker-arm.obj", {10044, 20088, 20088, 0, 0}},
    {"spot.obj", {2930, 5856, 5856, 0, 0}},         {"stanford-bunny.obj", {35947, 69451, 69451, 223, 0}},
    {"suzanne.obj", {507, 500, 968, 42, 1}},        {"teapot.obj", {3644, 6320, 6320, 1036, 0}}};

TEST(Models, AreReadAndSurviveEveryFormat) {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
  if (!std::filesystem::exists(folder)) {
    std::cout << "skipped: there is no folder " << folder << "\n";
    return;
  }
  for (const auto& [file, counts] : kModels) {
    if (battery::sanitized && counts.vertices > 20000) continue;  // smaller ones take the same ways
    SCOPED_TRACE(file);
    expect_read_and_kept(folder / file, counts);
  }
}

}  // namespace
}  // namespace plumb
