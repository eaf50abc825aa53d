// Writing: every double comes back bit for bit through every format, and the file is whole or not there.
#include "plumb/surface/file/write_mesh.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <bit>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "plumb/surface/file/read_mesh.hpp"
#include "surface/file/sample_files.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using enum MeshEncoding;
using Limits = std::numeric_limits<double>;

bool same_bits(const std::vector<Point3>& l, const std::vector<Point3>& r) {
  return l.size() == r.size() && (l.empty() || std::memcmp(l.data(), r.data(), l.size() * sizeof(Point3)) == 0);
}

// Triangles of doubles that decimals and readers get wrong: every vertex distinct, used once, in order.
PolygonMesh hard_doubles() {
  std::vector<double> numbers{-0.0,
                              Limits::denorm_min(),
                              -Limits::denorm_min(),
                              Limits::min(),
                              Limits::max(),
                              -Limits::max(),
                              std::nextafter(Limits::min(), 0),
                              0.1,
                              0.3,
                              1e23,
                              9007199254740994,
                              5e-324,
                              2.2250738585072011e-308,
                              1.7976931348623157e308,
                              123456789012345680,
                              8.41e21,
                              9.5e-5,
                              1.0 / 3,
                              std::nextafter(1, 2)};
  std::mt19937_64 random(11);
  while (numbers.size() < 9 * 500) {
    const double x = std::bit_cast<double>(random());
    if (std::isfinite(x)) numbers.push_back(x);
  }
  PolygonMesh mesh;
  for (std::size_t k = 0; k + 9 <= numbers.size(); k += 9) {
    for (std::size_t v = 0; v < 9; v += 3) {
      mesh.corners.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back({numbers[k + v], numbers[k + v + 1], numbers[k + v + 2]});
    }
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
  return mesh;
}

struct Target {
  MeshFormat format;
  std::optional<MeshEncoding> encoding;
};

const std::vector<Target> kTargets{{MeshFormat::obj, {}},    {MeshFormat::off, ascii},
                                   {MeshFormat::stl, {}},    {MeshFormat::ply, {}},
                                   {MeshFormat::ply, ascii}, {MeshFormat::ply, binary_big_endian}};

TEST(WriteMesh, EveryDoubleComesBackBitForBit) {
  const PolygonMesh mesh = hard_doubles();
  for (const auto& [format, encoding] : kTargets) {
    SCOPED_TRACE(name_of(format));
    LoadReport report;
    const PolygonMesh back = parse_mesh(format_mesh(mesh, format, encoding), format, "x", &report);
    EXPECT_TRUE(same_bits(back.vertices, mesh.vertices));
    EXPECT_EQ(back.corners, mesh.corners);
    EXPECT_EQ(back.first, mesh.first);
    EXPECT_EQ(report.encoding, encoding.value_or(format == MeshFormat::ply ? binary_little_endian : ascii));
  }
}

TEST(WriteMesh, PolygonsComeBackAndStlTriangulatesThem) {
  PolygonMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {9, 9, 9}}, {0, 1, 2, 3, 2, 1, 0}, {0, 4, 7}};
  for (int k = 0; k < 300; ++k) mesh.corners.push_back(static_cast<std::uint32_t>(k % 5));
  mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));  // more corners than a byte can count
  for (const auto& [format, encoding] : kTargets) {
    const PolygonMesh back = parse_mesh(format_mesh(mesh, format, encoding), format, "x");
    if (format == MeshFormat::stl) {
      EXPECT_EQ(back.first.size() - 1, 2U + 1U + 298U);
      continue;
    }
    EXPECT_EQ(back.vertices, mesh.vertices);
    EXPECT_EQ(back.corners, mesh.corners);
    EXPECT_EQ(back.first, mesh.first);
  }
}

TEST(WriteMesh, BinaryStlHoldsSinglesOnly) {
  const PolygonMesh mesh = surface_test::tetrahedron();
  LoadReport report;
  parse_mesh(format_mesh(mesh, MeshFormat::stl, binary_little_endian), MeshFormat::stl, "x", &report);
  EXPECT_EQ(report.encoding, binary_little_endian);
  for (const double x : {0.1, 1e-46, 1e39, -Limits::max()}) {
    PolygonMesh other = mesh;
    other.vertices[2].y = x;
    try {
      format_mesh(other, MeshFormat::stl, binary_little_endian, "out.stl");
      ADD_FAILURE() << x << " was written";
    } catch (const MeshFileError& error) {
      EXPECT_EQ(error.problem, MeshFileProblem::not_representable);
      EXPECT_NE(std::string(error.what()).find("vertex 2 is no float32"), std::string::npos) << error.what();
    }
  }
}

TEST(WriteMesh, RefusesWhatNoFileShouldHold) {
  const PolygonMesh mesh = surface_test::tetrahedron();
  PolygonMesh wrong = mesh;
  wrong.vertices[3].z = NAN;
  EXPECT_THROW(format_mesh(wrong, MeshFormat::obj), NonFinite);
  wrong = mesh;
  wrong.corners[5] = 4;
  EXPECT_THROW(format_mesh(wrong, MeshFormat::off), Error);
  for (const auto& first : {std::vector<std::uint32_t>{}, {1, 12}, {0, 2, 12}, {0, 3, 6, 9}, {0, 13}, {0, 9, 6, 12}}) {
    wrong = mesh;
    wrong.first = first;
    EXPECT_THROW(format_mesh(wrong, MeshFormat::ply), Error);
  }
  EXPECT_THROW(format_mesh(mesh, MeshFormat::obj, binary_little_endian), MeshFileError);
  EXPECT_THROW(format_mesh(mesh, MeshFormat::stl, binary_big_endian), MeshFileError);
  for (const auto read_only : {MeshFormat::three_mf, MeshFormat::gltf})
    EXPECT_THROW(format_mesh(mesh, read_only), MeshFileError);
}

struct Folder {
  fs::path path = fs::temp_directory_path() / "plumb_write_mesh_test";
  Folder() { fs::remove_all(path), fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  [[nodiscard]] auto files() const { return std::distance(fs::directory_iterator(path), fs::directory_iterator()); }
};

MeshFileProblem problem_of_writing(const fs::path& path, const WriteOptions& options = {}) {
  try {
    write_mesh(path, surface_test::tetrahedron(), options);
  } catch (const MeshFileError& error) {
    EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
    return error.problem;
  }
  ADD_FAILURE() << path << " was written";
  return MeshFileProblem::syntax;
}

TEST(WriteMesh, TheFileIsReplacedWhole) {
  const Folder folder;
  const fs::path file = folder.path / "mesh.PLY", link = folder.path / "link.ply";
  std::ofstream(file) << "old";
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("mesh.PLY", link);
  const TriangleMesh mesh = read_mesh((write_mesh(link, surface_test::tetrahedron()), file));
  EXPECT_EQ(mesh.vertices, surface_test::tetrahedron().vertices);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  std::ofstream(folder.path / "mesh.PLY.part0") << "of somebody else";
  write_mesh(file, mesh, {.encoding = ascii});
  EXPECT_EQ(read_mesh(file).triangles, mesh.triangles);
  EXPECT_EQ(folder.files(), 3) << "nothing but the file, the link and the stranger's";
}

TEST(WriteMesh, FailuresAreReportedAndLeaveNothing) {
  const Folder folder;
  EXPECT_EQ(problem_of_writing("/dev/full", {.format = MeshFormat::obj}), MeshFileProblem::unwritable);
  EXPECT_EQ(problem_of_writing(folder.path / "none" / "a.obj"), MeshFileProblem::unwritable);
  EXPECT_EQ(problem_of_writing(folder.path / "a.xyz"), MeshFileProblem::unknown_format);
  EXPECT_EQ(problem_of_writing(folder.path / "noname"), MeshFileProblem::unknown_format);
  fs::create_directory(folder.path / "folder.off");
  EXPECT_EQ(problem_of_writing(folder.path / "folder.off"), MeshFileProblem::unwritable);
  EXPECT_EQ(folder.files(), 1);
  write_mesh("/dev/null", surface_test::tetrahedron(), {.format = MeshFormat::stl});
}

TEST(WriteMesh, AFullDiskLeavesTheOldFile) {
  const Folder folder;
  const fs::path file = folder.path / "mesh.obj";
  std::ofstream(file) << "old";
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 5000;
  setrlimit(RLIMIT_FSIZE, &small);
  std::string said;
  try {
    write_mesh(file, hard_doubles());
  } catch (const MeshFileError& error) {
    EXPECT_EQ(error.problem, MeshFileProblem::unwritable);
    said = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(said.find("cannot be written: File too large"), std::string::npos) << said;
  EXPECT_EQ(fs::file_size(file), 3U);
  EXPECT_EQ(folder.files(), 1);
}

}  // namespace
}  // namespace plumb
