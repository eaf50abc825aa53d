// Reports about mesh files that are refused or misread, and about polygons that are cut into triangles.
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "docs/bugs_of_others/case.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "plumb/predicates.hpp"
#include "plumb/query/ray/parity.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/planar/triangulate.hpp"
#include "plumb/surface/section/section.hpp"
#include "plumb/surface/topology/topology.hpp"

namespace plumb::docs {
namespace {

std::string counted(const PolygonMesh& mesh) {
  return std::to_string(mesh.vertices.size()) + " vertices, " + std::to_string(mesh.first.size() - 1) + " faces";
}

std::string told_of(std::string_view bytes, const std::string& name) {
  LoadReport report;
  const PolygonMesh mesh = parse_mesh(bytes, name, &report);
  return std::string(name_of(report.encoding)) + " " + std::string(name_of(report.format)) + ", " + counted(mesh);
}

/// A binary STL of one triangle, whose header begins as text does.
std::string binary_stl() {
  std::string bytes = "solid cube";
  bytes.resize(80, ' ');
  const std::array<std::uint32_t, 1> count{1};
  const std::array<float, 12> facet{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  bytes.append(reinterpret_cast<const char*>(count.data()), 4);
  bytes.append(reinterpret_cast<const char*>(facet.data()), 48);
  bytes.append(2, '\0');
  return bytes;
}

std::string ascii_stl(std::string_view end) {
  return "solid cube\n  facet normal 0.000000e+00 0.000000e+00 1.000000e+00\n    outer loop\n"
         "      vertex 0.0 0.0 0.0\n      vertex 1.0 0.0 0.0\n      vertex 0.0 1.0 0.0\n    endloop\n  endfacet\n" +
         std::string(end);
}

/// The first facet of the report.
constexpr std::string_view exponents =
    "solid part\n   facet normal 3.530327e-01 -3.218319e-01 -8.785170e-01\n      outer loop\n"
    "         vertex 5.502911e-01 -7.287032e-01 3.099700e-01\n         vertex 2.905658e-01 -3.847714e-01 7.960480e-02\n"
    "         vertex 4.099400e-01 -2.538241e-01 7.960480e-02\n      endloop\n   endfacet\nendsolid part\n";

/// Two tetrahedra, the second beside the first, each with its faces below its own corners.
constexpr std::string_view interleaved =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -2 -4 -1\n"
    "v 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\nf -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -2 -4 -1\n";

/// All of a PLY but its first lines.
constexpr std::string_view triangle_ply =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

constexpr std::array cases{
    Case{"nschloe/meshio#530", [] { return told_of(binary_stl(), "cube.stl"); }},
    Case{"Innoptech/OpenSTL#25",
         [] {
           const PolygonMesh mesh = parse_mesh(exponents, "part.stl");
           EXPECT_EQ(mesh.vertices[0], (Point3{0.5502911, -0.7287032, 0.30997}));
           return told_of(exponents, "part.stl");
         }},
    Case{"nschloe/meshio#745", [] { return told_of(ascii_stl("endsolid cube\n"), "cube.stl"); }},
    Case{"cnr-isti-vclab/meshlab#168", [] { return told_of(ascii_stl("endsolid"), "face_5_facet_1.stl"); }},
    Case{"mikedh/trimesh#2556",
         [] {
           const TriangleMesh mesh = triangulate(parse_mesh(interleaved, "two.obj"));
           EXPECT_TRUE(is_oriented_closed(mesh));
           EXPECT_EQ(mesh.triangles[4], (TriangleMesh::Triangle{4, 6, 5}));
           return told_of(interleaved, "two.obj") + ", volume " + told(volume(mesh));
         }},
    Case{"f3d-app/f3d#2320",
         [] {
           constexpr std::string_view text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf -3//-1 -2//-1 -1//-1\n";
           EXPECT_EQ(parse_mesh(text, "buddha.obj").corners, (std::vector<std::uint32_t>{0, 1, 2}));
           return told_of(text, "buddha.obj");
         }},
    Case{"cinder/Cinder#1121",
         [] {
           constexpr std::string_view text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1/1/1 2/2/2 3/3/3 \\\n 4/4/4\n";
           EXPECT_EQ(parse_mesh(text, "broken.obj").corners, (std::vector<std::uint32_t>{0, 1, 2, 3}));
           return told_of(text, "broken.obj");
         }},
    Case{"assimp/assimp#3532",
         [] { return told_of("# head\\Solid\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "head.obj"); }},
    Case{"simbody/simbody#747", [] { return told_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf\t1\t2\t3\n", "tabs.obj"); }},
    Case{"libigl/libigl#480",
         [] { return told_of("OFF\n# cube\n\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "cube_1.off"); }},
    Case{"fougue/mayo#258", [] { return told_of("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "socket.off"); }},
    Case{"assimp/assimp#819",
         [] { return told_of("ply\nformat ascii 1.0\ncomment\n" + std::string(triangle_ply), "cube.ply"); }},
    Case{"nmwsharp/happly#12",
         [] {
           return told_of("ply\nformat ascii 1.0\nobj_info Generated by CloudCompare!\n" + std::string(triangle_ply),
                          "cloud.ply");
         }},
    Case{"cnr-isti-vclab/meshlab#290",
         [] {
           return told_of(
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 1\nproperty list ushort uint vertex_indices\nproperty list uchar float texcoord\n"
               "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 6 0 0 1 0 0 1\n",
               "lists.ply");
         }},
    Case{"GridSpace/grid-apps#264",
         [] {
           TriangleMesh steps;  // three boxes side by side
           for (const double height : {0.2, 0.4, 0.6}) {
             const auto first = static_cast<std::uint32_t>(steps.vertices.size());
             for (int i = 0; i < 8; ++i)
               steps.vertices.push_back({5 * height + (i & 1) * 0.5, 1.0 * (i >> 1 & 1), (i >> 2) * height});
             for (const auto& [a, b, c] : {TriangleMesh::Triangle{0, 2, 1},
                                           {1, 2, 3},
                                           {4, 5, 6},
                                           {5, 7, 6},
                                           {0, 1, 4},
                                           {1, 5, 4},
                                           {2, 6, 3},
                                           {3, 6, 7},
                                           {0, 4, 2},
                                           {2, 4, 6},
                                           {1, 3, 5},
                                           {3, 7, 5}})
               steps.triangles.push_back({first + a, first + b, first + c});
           }
           std::string all;
           for (const double height : {0.2, 0.4, 0.6})
             all +=
                 (all.empty() ? "" : ", ") + std::to_string(section(steps, Plane3{{0, 0, 1}, height}).contours.size());
           return all + " contours";
         }},
    Case{"greenm01/poly2tri#18",
         [] {
           const Polygon2 polygon{{{1033, 309},
                                   {1032, 309.14935064935065},
                                   {1032, 331.55555555555617},
                                   {1031.9802955665025, 332},
                                   {968, 332},
                                   {968, 318.70779220779224},
                                   {879, 332},
                                   {1024, 512}}};
           PolygonMesh face;
           for (const Point2& p : polygon.vertices) {
             face.corners.push_back(static_cast<std::uint32_t>(face.vertices.size()));
             face.vertices.push_back({p.x, p.y, 0});
           }
           face.first.push_back(8);
           const auto& v = polygon.vertices;  // which corners are beyond the edge from the last to the first?
           EXPECT_EQ(orient2d(v[7], v[0], v[2]), Sign::positive);
           EXPECT_EQ(orient2d(v[7], v[0], v[3]), Sign::positive);
           std::uint64_t fans = 0;
           const TriangleMesh cut = triangulate(face, &fans);
           return std::to_string(cut.triangles.size()) + " triangles, " + std::to_string(fans) + " fans";
         }},
};

}  // namespace

std::span<const Case> file_cases() { return cases; }

}  // namespace plumb::docs
