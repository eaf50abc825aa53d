// Real meshes: each is read, its counts are those known of it, and it survives every format.
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>

#include "certify/sanitized.hpp"
#include "plumb/surface.hpp"

namespace plumb {
namespace {

struct Model {
  const char* file;
  std::uint64_t vertices, faces, triangles, boundary, non_manifold;
};

// Counts as other tools tell them; igea and horse are closed, so twice the vertices less four faces.
constexpr Model kModels[] = {
    {"beetle.obj", 1148, 2053, 2053, 296, 47},    {"cheburashka.obj", 6669, 13334, 13334, 0, 0},
    {"cow.obj", 2903, 5804, 5804, 0, 0},          {"fandisk.obj", 6475, 12946, 12946, 0, 0},
    {"horse.ply", 48485, 96966, 96966, 0, 0},     {"igea.ply", 134345, 268686, 268686, 0, 0},
    {"nefertiti.obj", 49971, 99938, 99938, 0, 0}, {"rocker-arm.obj", 10044, 20088, 20088, 0, 0},
    {"spot.obj", 2930, 5856, 5856, 0, 0},         {"stanford-bunny.obj", 35947, 69451, 69451, 223, 0},
    {"suzanne.obj", 507, 500, 968, 42, 1},        {"teapot.obj", 3644, 6320, 6320, 1036, 0}};

TEST(Models, AreReadAndSurviveEveryFormat) {
  const std::filesystem::path folder = std::filesystem::path(PLUMB_SHARED_DIR) / "models";
  if (!std::filesystem::exists(folder)) {
    std::cout << "skipped: there is no folder " << folder << "\n";
    return;
  }
  for (const auto& model : kModels) {
    if (battery::sanitized && model.vertices > 20000) continue;  // smaller ones take the same ways
    SCOPED_TRACE(model.file);
    LoadReport report;
    const PolygonMesh mesh = read_polygon_mesh(folder / model.file, &report);
    EXPECT_EQ(report.vertices, model.vertices);
    EXPECT_EQ(report.faces, model.faces);
    EXPECT_EQ(report.dropped_faces, 0U);
    std::uint64_t fans = 0;
    const TriangleMesh triangles = triangulate(mesh, &fans);
    EXPECT_EQ(triangles.triangles.size(), model.triangles);
    EXPECT_EQ(fans, 0U);
    const MeshStatistics said = mesh_statistics(triangles);
    EXPECT_EQ(said.boundary_edges, model.boundary);
    EXPECT_EQ(said.non_manifold_edges, model.non_manifold);
    EXPECT_EQ(said.inconsistent_edges, 0U);
    for (const auto format : {MeshFormat::obj, MeshFormat::off, MeshFormat::ply}) {
      const PolygonMesh back = parse_mesh(format_mesh(mesh, format), format, "x");
      EXPECT_TRUE(back.vertices == mesh.vertices && back.corners == mesh.corners && back.first == mesh.first);
    }
    const PolygonMesh stl = parse_mesh(format_mesh(mesh, MeshFormat::stl), MeshFormat::stl, "x");
    ASSERT_EQ(stl.corners.size(), 3 * model.triangles);
    EXPECT_EQ(stl.vertices.size(), said.vertices - said.repeated_vertices - said.unused_vertices);
    bool same = true;
    for (std::size_t k = 0; k < stl.corners.size(); ++k)
      same = same && stl.vertices[stl.corners[k]] == mesh.vertices[triangles.triangles[k / 3][k % 3]];
    EXPECT_TRUE(same);
  }
}

}  // namespace
}  // namespace plumb
