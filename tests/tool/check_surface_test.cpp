// Does `plumb check` say of each mesh whether it is closed, oriented, free of self-intersections and of degenerate
// triangles?
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "figure/basic/solids.hpp"
#include "plumb/surface/write_mesh.hpp"
#include "tool/check/surface.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

const TriangleMesh cube = solids::box({0, 0, 0}, {4, 4, 4});

SurfaceCheck checked(const TriangleMesh& mesh) {
  const MeshEdges edges = find_edges(mesh);
  return check_surface(mesh, edges, mesh_statistics(mesh, edges), "test");
}
std::string said_of(const TriangleMesh& mesh) { return surface_verdict(checked(mesh)); }

TriangleMesh without_last(TriangleMesh mesh) {
  mesh.triangles.pop_back();
  return mesh;
}
TriangleMesh with_one_turned(TriangleMesh mesh) {
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  return mesh;
}
TriangleMesh inside_out(const TriangleMesh& mesh) {
  TriangleMesh turned;
  solids::append(turned, mesh, true);
  return turned;
}
TriangleMesh with(TriangleMesh mesh, const TriangleMesh& other) {
  solids::append(mesh, other);
  return mesh;
}
/// A vertex in the middle of an edge of another triangle, with a triangle of no area between.
TriangleMesh with_a_sliver() {
  TriangleMesh mesh = cube;
  const auto [a, b, c] = mesh.triangles.back();
  const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
  const Point3 p = mesh.vertices[a], q = mesh.vertices[b];
  mesh.vertices.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
  mesh.triangles.back() = {a, middle, c};
  mesh.triangles.insert(mesh.triangles.end(), {{middle, b, c}, {a, b, middle}});
  return mesh;
}
/// Each triangle with vertices of its own.
TriangleMesh soup(const TriangleMesh& mesh) {
  TriangleMesh apart;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const auto n = static_cast<std::uint32_t>(apart.vertices.size());
    for (const std::uint32_t v : t) apart.vertices.push_back(mesh.vertices[v]);
    apart.triangles.push_back({n, n + 1, n + 2});
  }
  return apart;
}

TEST(CheckSurface, SaysWhatAMeshIs) {
  EXPECT_EQ(said_of(cube), "closed, oriented, free of self-intersections, free of degenerate triangles");
  EXPECT_EQ(said_of(without_last(cube)),
            "not closed, oriented, free of self-intersections, free of degenerate triangles");
  EXPECT_EQ(said_of(with_one_turned(cube)),
            "closed, not oriented, free of self-intersections, free of degenerate triangles");
  EXPECT_EQ(said_of(inside_out(cube)),
            "closed, oriented inward, free of self-intersections, free of degenerate triangles");
  EXPECT_EQ(said_of(with(cube, solids::box({2, 1, 1}, {6, 3, 3}))),
            "closed, oriented, self-intersecting, free of degenerate triangles");
  EXPECT_EQ(said_of(with(cube, solids::box({4, 5, 5}, {6, 6, 6}))),
            "closed, oriented, free of self-intersections, free of degenerate triangles");
  EXPECT_EQ(said_of({{{0, 0, 0}}, {}}), "none: there are no triangles");
}

// A tip on a face of the cube: no edge of the two is in the other.
TEST(CheckSurface, TellsTouchingFromOverlapping) {
  const TriangleMesh touching =
      with(cube, {{{4, 1, 2}, {9, 1, 2}, {9, 2, 2}, {9, 1, 3}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
  EXPECT_EQ(said_of(touching), "closed, oriented, touching itself, free of degenerate triangles");
  const SurfaceCheck c = checked(touching);
  EXPECT_EQ(c.met.overlapping, 0U);
  EXPECT_GT(c.met.touching, 0U);
}

TEST(CheckSurface, FindsTrianglesWithoutArea) {
  const SurfaceCheck c = checked(with_a_sliver());
  EXPECT_TRUE(c.closed && c.oriented && !c.inside_out);
  EXPECT_EQ(c.degenerate, 1U);
  EXPECT_TRUE(surface_verdict(c).ends_with(", with degenerate triangles"));
  TriangleMesh twice = cube;
  twice.triangles.push_back({0, 1, 1});
  EXPECT_EQ(checked(twice).degenerate, 1U);
  EXPECT_TRUE(checked(twice).closed);
}

TEST(CheckSurface, SaysWhereVerticesAreRepeated) {
  EXPECT_EQ(said_of(soup(cube)),
            "not closed, oriented, touching itself (28 vertices lie where another is: triangles that meet there share "
            "none, and touch), free of degenerate triangles");
}

TEST(CheckSurface, OfEdgesOfMoreThanTwoFaces) {
  // Two tetrahedra of one edge, sharing its vertices: four faces there, two each way.
  TriangleMesh two{{{0, 0, 0}, {0, 0, 4}, {4, 0, 2}, {4, 1, 2}, {-4, 0, 2}, {-4, -1, 2}},
                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 4, 1}, {0, 1, 5}, {1, 4, 5}, {4, 0, 5}}};
  EXPECT_TRUE(checked(two).closed);
  EXPECT_TRUE(checked(two).oriented);
  two.triangles.pop_back();  // an open one: three edges of one face
  EXPECT_FALSE(checked(two).closed);
  EXPECT_TRUE(checked(two).oriented);
  // Three faces that run along one edge the same way cannot be wound alike.
  const TriangleMesh fan{two.vertices, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  EXPECT_FALSE(checked(fan).oriented);
  const TriangleMesh mixed{two.vertices, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  EXPECT_TRUE(checked(mixed).oriented);
}

TEST(CheckSurface, JsonHoldsTheSameAndDefectsFailWhereAskedTo) {
  const Folder folder;
  write_mesh(folder / "cube.obj", cube);
  write_mesh(folder / "open.obj", without_last(cube));
  write_mesh(folder / "turned.obj", with_one_turned(cube));
  write_mesh(folder / "inward.obj", inside_out(cube));
  write_mesh(folder / "crossed.obj", with(cube, solids::box({2, 1, 1}, {6, 3, 3})));
  write_mesh(folder / "sliver.obj", with_a_sliver());
  const std::vector<std::pair<std::string, std::string>> first{{"open.obj", "open"},
                                                               {"turned.obj", "unoriented"},
                                                               {"inward.obj", "inside-out"},
                                                               {"crossed.obj", "self-intersecting"},
                                                               {"sliver.obj", "degenerate"}};
  const std::string check = "cd " + (folder / "") + " && $PLUMB check ";
  for (const auto& [file, defect] : first) {
    EXPECT_EQ(run(check + "--fail-on-defect " + defect + " " + file).code, 1) << file;
    EXPECT_EQ(run(check + "--fail-on-defect " + defect + " cube.obj").code, 0) << defect;
    EXPECT_EQ(run(check + "--fail-on-defect " + defect + " cube.obj " + file).code, 1) << file;
    EXPECT_EQ(run(check + file).code, 0) << file;
  }
  EXPECT_EQ(run(check + "--fail-on-defect open --fail-on-defect inside-out turned.obj crossed.obj").code, 0);
  EXPECT_EQ(run(check + "--fail-on-defect none cube.obj").code, 2);
  const json report = json::parse(run(check + "cube.obj crossed.obj --json").out);
  EXPECT_EQ(report.at("meshes")[0].at("surface"), (json{{"closed", true},
                                                        {"oriented", true},
                                                        {"inside_out", false},
                                                        {"self_intersecting", false},
                                                        {"touching_pairs", 0},
                                                        {"overlapping_pairs", 0},
                                                        {"degenerate_triangles", 0}}));
  const json crossed = report.at("meshes")[1];
  const json pairs = json::parse(run("cd " + (folder / "") + " && $PLUMB intersect crossed.obj --json").out);
  EXPECT_EQ(crossed.at("surface").at("self_intersecting"), true);
  EXPECT_EQ(crossed.at("surface").at("overlapping_pairs"), pairs.at("overlapping"));
  EXPECT_EQ(crossed.at("surface").at("touching_pairs"), pairs.at("touching"));
  EXPECT_THAT(std::string(crossed.at("verdict").at("mesh")), HasSubstr("pairs of triangles that overlap"));
  EXPECT_THAT(std::string(crossed.at("verdict").at("advice")), HasSubstr("`plumb intersect --obj` shows them"));
}

TEST(CheckSurface, OfTheTeapot) {
  const std::filesystem::path teapot = std::filesystem::path(PLUMB_SHARED_DIR) / "models" / "teapot.obj";
  if (!std::filesystem::exists(teapot)) {
    std::cout << "skipped: there is no file " << teapot << "\n";
    return;
  }
  EXPECT_THAT(run("$PLUMB check " + teapot.string()).out,
              HasSubstr("\n  surface     not closed, oriented, self-intersecting (403 vertices lie where another is: "
                        "triangles that meet there share none, and touch), free of degenerate triangles\n"));
}

}  // namespace
}  // namespace plumb::tool
