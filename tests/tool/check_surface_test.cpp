// Does `plumb check` say of each mesh whether it is closed, oriented, free of self-intersections and of degenerate
// triangles?
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "figure/basic/solids.hpp"
#include "plumb/figure/basic/equal_points.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/check/surface.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

const TriangleMesh cube = solids::box({0, 0, 0}, {4, 4, 4});

SurfaceFaults checked(const TriangleMesh& mesh) {
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
            "2 shells, closed, oriented, self-intersecting, free of degenerate triangles");
  EXPECT_EQ(said_of(with(cube, solids::box({4, 5, 5}, {6, 6, 6}))),
            "2 shells, closed, oriented, free of self-intersections, free of degenerate triangles");
  EXPECT_EQ(said_of({{{0, 0, 0}}, {}}), "none: there are no triangles");
}

// A tip on a face of the cube: no edge of the two is in the other.
TEST(CheckSurface, TellsTouchingFromOverlapping) {
  const TriangleMesh touching =
      with(cube, {{{4, 1, 2}, {9, 1, 2}, {9, 2, 2}, {9, 1, 3}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
  EXPECT_EQ(said_of(touching), "2 shells, closed, oriented, touching itself, free of degenerate triangles");
  const SurfaceFaults c = checked(touching);
  EXPECT_EQ(c.met.overlapping, 0U);
  EXPECT_GT(c.met.touching, 0U);
}

TEST(CheckSurface, FindsTrianglesWithoutArea) {
  const SurfaceFaults c = checked(with_a_sliver());
  EXPECT_TRUE(c.closed && c.oriented && !c.inside_out());
  EXPECT_EQ(c.degenerate, 1U);
  EXPECT_TRUE(surface_verdict(c).ends_with(", with degenerate triangles"));
  TriangleMesh twice = cube;
  twice.triangles.push_back({0, 1, 1});
  EXPECT_EQ(checked(twice).degenerate, 1U);
  EXPECT_TRUE(checked(twice).closed);
}

TEST(CheckSurface, SaysWhereVerticesAreRepeated) {
  EXPECT_EQ(said_of(soup(cube)),
            "12 shells, not closed, oriented, touching itself (28 vertices lie where another is: triangles that meet "
            "there share "
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
                                                        {"touching", 0},
                                                        {"overlapping", 0},
                                                        {"degenerate_triangles", 0},
                                                        {"shell_count", 1},
                                                        {"closed_shells", 1},
                                                        {"inside_out_shells", 0},
                                                        {"crossing_shells", 0},
                                                        {"internal_walls", 0},
                                                        {"non_manifold_vertices", 0},
                                                        {"vertices_on_edges", 0},
                                                        {"duplicate_triangles", 0},
                                                        {"opposite_triangles", 0}}));
  const json crossed = report.at("meshes")[1];
  const json pairs = json::parse(run("cd " + (folder / "") + " && $PLUMB intersect crossed.obj --json").out);
  EXPECT_EQ(crossed.at("surface").at("self_intersecting"), true);
  EXPECT_EQ(crossed.at("surface").at("overlapping"), pairs.at("overlapping"));
  EXPECT_EQ(crossed.at("surface").at("touching"), pairs.at("touching"));
  EXPECT_THAT(std::string(crossed.at("verdict").at("faults")), HasSubstr("pairs of triangles that overlap"));
  EXPECT_THAT(std::string(crossed.at("verdict").at("advice")), HasSubstr("`plumb intersect --obj` shows them"));
}

/// A mesh that has a defect, and what is said of it.
struct Defective {
  std::string defect;
  TriangleMesh mesh;
  std::string wrong, to_do;
};

TriangleMesh welded(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> first = first_equal(mesh.vertices);
  TriangleMesh once{{}, mesh.triangles};
  std::vector<std::uint32_t> number(first.size());
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    if (first[v] == v) once.vertices.push_back(mesh.vertices[v]);
    number[v] = first[v] == v ? static_cast<std::uint32_t>(once.vertices.size() - 1) : number[first[v]];
  }
  for (TriangleMesh::Triangle& t : once.triangles)
    for (std::uint32_t& v : t) v = number[v];
  return once;
}
TriangleMesh with_last_again(TriangleMesh mesh, bool turned) {
  mesh.triangles.push_back(mesh.triangles.back());
  if (turned) std::swap(mesh.triangles.back()[0], mesh.triangles.back()[1]);
  return mesh;
}
/// A triangle in two, at the middle of an edge of its neighbor.
TriangleMesh with_a_junction() {
  TriangleMesh mesh = with_a_sliver();
  mesh.triangles.pop_back();
  return mesh;
}

std::vector<Defective> defective_meshes() {
  const TriangleMesh far = solids::box({5, 5, 5}, {7, 7, 7}),
                     wall{{{1, 0, 0}, {1, 4, 0}, {1, 4, 4}, {1, 0, 4}}, {{0, 1, 2}, {0, 2, 3}}};
  return {
      {"inside-out", with(cube, inside_out(far)), "1 shell wound inside out", "turn shell 1 and no other;"},
      {"inside-out", with(inside_out(far), cube), "1 shell wound inside out", "turn shell 0 and no other;"},
      {"inside-out", with(inside_out(cube), inside_out(far)), "2 shells wound inside out", "turn all triangles;"},
      {"inside-out", with(cube, solids::box({1, 1, 1}, {2, 2, 2})), "1 shell wound inside out",
       "turn shell 1 and no other, or leave out what is a solid within a solid and no cavity;"},
      {"non-manifold-edge", welded(with(cube, solids::box({4, 4, 0}, {5, 5, 4}))), "1 edge of more than two faces",
       "split edges of more than two faces;"},
      {"non-manifold-vertex", welded(with(cube, solids::box({4, 4, 4}, {5, 5, 5}))), "1 non-manifold vertex",
       "split non-manifold vertices"},
      {"vertex-on-edge", with_a_junction(), "1 vertex on an edge (T-junction); 3 open edges",
       "divide edges where a vertex is on them; close open edges that are left;"},
      {"duplicate", with_last_again(cube, false), "1 duplicate triangle", "leave out duplicate triangles;"},
      {"opposite", with_last_again(cube, true), "1 triangle opposite to another", "leave out triangles opposite"},
      {"internal-wall", with(cube, wall), "1 wall inside of a solid; 4 vertices on edges (T-junctions); 4 open edges",
       "leave out walls inside of solids; divide edges where a vertex is left on them; part triangles"},
      {"crossing-shells", with(cube, solids::box({2, 1, 1}, {6, 3, 3})), "2 shells that cross others",
       "unite shells that cross (`plumb resolve`), or part them;"},
  };
}

TEST(CheckSurface, NamesEachDefectAndWhatToDo) {
  const Folder folder;
  write_mesh(folder / "cube.obj", cube);
  const std::string check = "cd " + (folder / "") + " && $PLUMB check ";
  int files = 0;
  for (const Defective& d : defective_meshes()) {
    const std::string file = std::to_string(files++) + ".obj";
    write_mesh(folder / file, d.mesh);
    const Outcome o = run(check + "--fail-on-defect " + d.defect + " " + file);
    EXPECT_EQ(o.code, 1) << d.defect;
    EXPECT_THAT(o.out, HasSubstr(d.wrong)) << d.defect;
    EXPECT_THAT(o.out, HasSubstr("  to do       " + d.to_do)) << d.defect;
    EXPECT_EQ(run(check + "-q --brief --fail-on-defect " + d.defect + " cube.obj").code, 0) << d.defect;
  }
}

TEST(CheckSurface, ClosenessIsAskedFor) {
  const Folder folder;
  write_mesh(folder / "cube.obj", cube);
  const std::string check =
      "cd " + (folder / "") + " && $PLUMB check cube.obj --brief --fail-on-defect close-vertices ";
  EXPECT_EQ(run(check + "--nearer-than 4").code, 0);
  const Outcome near = run(check + "--nearer-than 4.000000000000001");
  EXPECT_EQ(near.code, 1);
  EXPECT_THAT(near.out, HasSubstr("8 vertices nearer than 4.000000000000001"));
  EXPECT_EQ(run(check).code, 2);
  EXPECT_THAT(run(check).err, HasSubstr("--nearer-than LENGTH"));
  EXPECT_EQ(run(check + "--nearer-than -1").code, 2);
}

TEST(CheckSurface, ReportsEachShell) {
  const Folder folder;
  TriangleMesh mesh = with(cube, inside_out(solids::box({1, 1, 1}, {3, 3, 3})));
  solids::append(mesh, solids::box({2, 2, 2}, {2.5, 2.5, 2.5}), true);
  write_mesh(folder / "shells.obj", mesh);
  const Outcome o = run("cd " + (folder / "") + " && $PLUMB check shells.obj --json report.json");
  EXPECT_THAT(o.out,
              HasSubstr("  shells      3, 3 of them closed\n"
                        "              0: 12 triangles from 0 on, closed, volume 64\n"
                        "              1: 12 triangles from 12 on, closed, volume -8, in shell 0\n"
                        "              2: 12 triangles from 24 on, closed, volume -0.125, in shell 1, inside out\n"));
  const json report = json::parse(content(folder / "report.json"));
  const json shell = report.at("meshes")[0].at("shells")[2];
  EXPECT_EQ(shell, (json{{"shell", 2},
                         {"first_triangle", 24},
                         {"triangles", 12},
                         {"closed", true},
                         {"oriented", true},
                         {"volume", -0.125},
                         {"volume_sign", -1},
                         {"depth", 2},
                         {"parent", 1},
                         {"inside_out", true},
                         {"internal_wall", false},
                         {"meets_another", false},
                         {"crosses_another", false}}));
  EXPECT_EQ(report.at("meshes")[0].at("surface").at("inside_out_shells"), 1);
}

TEST(CheckSurface, DefectsAreDocumented) {
  const std::string help = run("$PLUMB check --help").out;
  const std::string page = content(std::string(PLUMB_SOURCE_DIR) + "/docs/meshes.md");
  for (const std::string_view defect : surface_defects) {
    EXPECT_THAT(help, HasSubstr("\n       " + std::string(defect) + "\n")) << defect;
    EXPECT_THAT(page, HasSubstr("\n| `" + std::string(defect) + "` | ")) << defect;
  }
}

TEST(CheckSurface, OfFilesOnWhichChecksFallShort) {
  const std::filesystem::path cases = std::filesystem::path(PLUMB_SHARED_DIR) / "cases";
  if (!std::filesystem::exists(cases)) {
    std::cout << "skipped: there is no folder " << cases << "\n";
    return;
  }
  const std::vector<std::array<std::string, 3>> files{
      {"one_of_two_shells_inverted.obj", "inside-out", "turn shell 1 and no other"},
      {"larger_shell_inverted.obj", "inside-out", "turn shell 1 and no other"},
      {"two_shells_one_vertex.obj", "non-manifold-vertex", "1 non-manifold vertex"},
      {"t_junctions.stl", "vertex-on-edge", "1 vertex on an edge"},
      {"edge_of_four_faces.stl", "non-manifold-edge", "1 edge of more than two faces"},
      {"internal_wall.stl", "internal-wall", "1 wall inside of a solid"}};
  for (const auto& [file, defect, said] : files) {
    const Outcome o = run("$PLUMB check --fail-on-defect " + defect + " " + (cases / file).string());
    EXPECT_EQ(o.code, 1) << file;
    EXPECT_THAT(o.out, HasSubstr(said)) << file;
  }
}

TEST(CheckSurface, OfTheTeapot) {
  const std::filesystem::path teapot = std::filesystem::path(PLUMB_SHARED_DIR) / "models" / "teapot.obj";
  if (!std::filesystem::exists(teapot)) {
    std::cout << "skipped: there is no file " << teapot << "\n";
    return;
  }
  EXPECT_THAT(
      run("$PLUMB check " + teapot.string()).out,
      HasSubstr(
          "\n  surface     19 shells, not closed, oriented, self-intersecting (403 vertices lie where another is: "
          "triangles that meet there share none, and touch), free of degenerate triangles\n"));
}

}  // namespace
}  // namespace plumb::tool
