// What is read from well-formed files, in every dialect.
#include "plumb/surface/file/read_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "surface/file/sample_files.hpp"

namespace plumb {
namespace {

using surface_test::raw;
using surface_test::sample_files;

// STL numbers vertices by their first use; so do we, to compare.
TriangleMesh renumbered(const PolygonMesh& mesh) {
  return read_mesh([&] {
    const auto path = std::filesystem::temp_directory_path() / "plumb_renumbered.stl";
    write_mesh(path, mesh);
    return path;
  }());
}

TEST(ReadMesh, EveryDialectHoldsTheSameTetrahedron) {
  const PolygonMesh expected = surface_test::tetrahedron();
  for (const auto& file : sample_files()) {
    SCOPED_TRACE(file.name);
    LoadReport report;
    const PolygonMesh mesh = parse_mesh(file.bytes, file.format, file.name, &report);
    if (file.format == MeshFormat::stl) {
      const TriangleMesh same = renumbered(expected);
      EXPECT_EQ(mesh.vertices, same.vertices);
      EXPECT_EQ(mesh.corners, to_polygons(same).corners);
      EXPECT_EQ(report.merged_vertices, 8U);
    } else {
      EXPECT_EQ(mesh.vertices, expected.vertices);
      EXPECT_EQ(mesh.corners, expected.corners);
      EXPECT_EQ(report.merged_vertices, 0U);
    }
    EXPECT_EQ(mesh.first, expected.first);
    EXPECT_EQ(report.format, file.format);
    EXPECT_EQ(report.encoding != MeshEncoding::ascii, file.binary);
    EXPECT_EQ(report.bytes, file.bytes.size());
    EXPECT_EQ(report.vertices, 4U);
    EXPECT_EQ(report.faces, 4U);
    EXPECT_EQ(report.polygons, 0U);
    EXPECT_EQ(report.inexact_decimals, 0U);
    EXPECT_EQ(report.decimals, file.binary ? 0U : file.format == MeshFormat::stl ? 36U : 12U);
    const bool has_short_face = file.name == "decorated.obj" || file.name == "colored.off";
    EXPECT_EQ(report.dropped_faces, has_short_face ? 1U : 0U);
  }
}

TEST(ReadMesh, FormatIsRecognizedByContentBeforeName) {
  for (const auto& file : sample_files()) {
    if (file.name != "headless.off") {  // only its name tells
      EXPECT_EQ(recognize_format("no_extension", file.bytes), file.format) << file.name;
    }
    EXPECT_EQ(recognize_format(file.name, file.bytes), file.format) << file.name;
    std::string upper = file.name;
    for (char& c : upper) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
    EXPECT_EQ(format_by_extension(upper), file.format);
    if (file.name == "headless.off") continue;
    for (const char* lie : {"lie.obj", "lie.off", "lie.stl", "lie.ply", "lie.txt"})
      EXPECT_EQ(recognize_format(lie, file.bytes), file.format) << file.name << " as " << lie;
  }
  EXPECT_EQ(recognize_format("notes.txt", "Dear reader,\n"), std::nullopt);
  EXPECT_EQ(recognize_format("notes", ""), std::nullopt);
}

TEST(ReadMesh, FilesOnDisk) {
  const auto folder = std::filesystem::temp_directory_path() / "plumb_read_mesh_test";
  std::filesystem::create_directories(folder);
  for (const auto& file : sample_files()) {
    std::ofstream(folder / file.name, std::ios::binary) << file.bytes;
    LoadReport report;
    EXPECT_EQ(read_mesh(folder / file.name, &report).triangles.size(), 4U) << file.name;
    EXPECT_EQ(report.format, file.format);
    EXPECT_EQ(report.fans, 0U);
  }
  std::filesystem::remove_all(folder);
}

TEST(ReadMesh, PolygonsAreKeptAndTriangulatedOnRequest) {
  LoadReport report;
  const PolygonMesh mesh = parse_mesh("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 2 0\nf 1 2 3 4\nf 4 3 5\nf 1 2 3 5 4\n",
                                      MeshFormat::obj, "x", &report);
  EXPECT_EQ(mesh.first, (std::vector<std::uint32_t>{0, 4, 7, 12}));
  EXPECT_EQ(report.polygons, 2U);
}

TEST(ReadMesh, DecimalsThatAreNotDoublesAreReported) {
  LoadReport report;
  parse_mesh("v 0.1 0.5 3\nv 1 0.25 1e23\nv 1 0 0\nf 1 2 3\n", MeshFormat::obj, "x", &report);
  EXPECT_EQ(report.decimals, 9U);
  EXPECT_EQ(report.inexact_decimals, 2U);
  EXPECT_EQ(report.largest_move, 8388608);  // 1e23 lies 2^23 beside its double
}

TEST(ReadMesh, SingleFloatsWidenExactly) {
  std::string bytes = std::string(80, ' ') + raw<std::uint32_t>(1) + std::string(12, '\0');
  const float corners[] = {0.1F, 1e-45F, -3.4028235e38F, 0, -0.0F, 1, 0.1F, 7, 8};
  for (const float x : corners) bytes += raw(x);
  const PolygonMesh mesh = parse_mesh(bytes + "\1\2", MeshFormat::stl, "x");
  ASSERT_EQ(mesh.vertices.size(), 3U);
  EXPECT_EQ(mesh.vertices[0].x, 0x1.99999ap-4);
  EXPECT_EQ(mesh.vertices[0].y, 0x1p-149);
  EXPECT_EQ(mesh.vertices[0].z, -0x1.fffffep127);
  EXPECT_TRUE(std::signbit(mesh.vertices[1].y));
}

TEST(ReadMesh, StlMergesEqualPointsOnly) {
  const std::string facet = "facet normal nan nan nan\nouter loop\n", end = "endloop endfacet\n";
  LoadReport report;
  const PolygonMesh mesh = parse_mesh("solid\n" + facet + "vertex -0 0 0 vertex 1 0 0 vertex 0 1 0\n" + end + facet +
                                          "vertex 0 -0 0 vertex 0 1 1e-300 vertex 1 0 0\n" + end + "endsolid",
                                      MeshFormat::stl, "x", &report);
  EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 3, 1}));
  EXPECT_TRUE(std::signbit(mesh.vertices[0].x)) << "the first of the equal points is kept";
  EXPECT_EQ(report.merged_vertices, 2U);
}

TEST(ReadMesh, PlyTriangleStrips) {
  const std::string header =
      " 1.0\nelement vertex 6\nproperty char x\nproperty char y\nproperty char z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
  const std::vector<int> strip{0, 1, 2, 3, 3, 4, -1, 5, 4, 3};
  std::string text = "ply\nformat ascii" + header, bytes = "ply\nformat binary_big_endian" + header;
  for (int v = 0; v < 6; ++v) {
    text += std::to_string(v) + " 0 1\n";
    bytes += std::string{static_cast<char>(v), '\0', '\1'};
  }
  text += std::to_string(strip.size());
  bytes += raw(static_cast<int>(strip.size()), true);
  for (const int v : strip) {
    text.append(" ").append(std::to_string(v));
    bytes += raw(v, true);
  }
  for (const auto& file : {text, bytes}) {
    LoadReport report;
    EXPECT_EQ(parse_mesh(file, MeshFormat::ply, "x", &report).corners,
              (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 3, 5, 4, 3}));
    EXPECT_EQ(report.dropped_faces, 2U);
  }
}

TEST(ReadMesh, PlyDataBehindALoneCarriageReturnMayBeginWithALineFeed) {
  const std::string header =
      "ply\rformat binary_little_endian 1.0\relement vertex 3\rproperty char x\rproperty char y\r"
      "property char z\relement face 1\rproperty list char char vertex_index\rend_header\r";
  const PolygonMesh mesh = parse_mesh(header + "\n\1\1\2\3\2\1\2\3\3" + std::string("\0\1\2", 3), MeshFormat::ply, "x");
  EXPECT_EQ(mesh.vertices.front(), (Point3{10, 1, 1}));
  EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2}));
}

}  // namespace
}  // namespace plumb
