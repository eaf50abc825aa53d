// Meshes packed by gzip: read as what they hold, refused where they are damaged, cut short or a bomb; and files of
// known formats that are not read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "plumb/surface/file/read_mesh.hpp"
#include "surface/file/gzipped.hpp"
#include "surface/file/sample_files.hpp"

namespace plumb {
namespace {

using surface_test::gzipped;
using surface_test::sample_files;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

PolygonMesh parse(const std::string& bytes, const std::string& name, const ReadOptions& options = {},
                  LoadReport* report = nullptr) {
  return parse_mesh(bytes, std::filesystem::path(name), report, options);
}

MeshFileError error_of(const std::string& bytes, const std::string& name, const ReadOptions& options = {}) {
  try {
    parse(bytes, name, options);
  } catch (const MeshFileError& e) {
    return e;
  }
  ADD_FAILURE() << name << " was read";
  return {MeshFileProblem::missing, "", {}, {}, ""};
}

TEST(Gzip, HoldsWhatTheFileHolds) {
  for (const auto& file : sample_files()) {
    SCOPED_TRACE(file.name);
    const std::string packed = gzipped(file.bytes);
    LoadReport plain, report;
    const PolygonMesh expected = parse_mesh(file.bytes, file.format, file.name, &plain);
    const PolygonMesh mesh = parse(packed, file.name + ".gz", {}, &report);
    EXPECT_EQ(mesh.vertices, expected.vertices);
    EXPECT_EQ(mesh.corners, expected.corners);
    EXPECT_EQ(report.format, file.format);
    EXPECT_EQ(report.bytes, file.bytes.size());
    EXPECT_EQ(report.packed_bytes, packed.size());
    EXPECT_EQ(plain.packed_bytes, 0U);
  }
}

TEST(Gzip, IsReadFromAFile) {
  const auto path = std::filesystem::temp_directory_path() / "plumb_gzip_test.obj.GZ";
  std::ofstream(path, std::ios::binary) << gzipped("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(read_mesh(path).triangles.size(), 1U);
  std::filesystem::remove(path);
}

TEST(Gzip, MembersFollowOneAnotherAndZerosPad) {
  const std::string first = gzipped("v 0 0 0\nv 1 0 0\n"), second = gzipped("v 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(parse(first + second, "a.obj.gz").vertices.size(), 3U);
  EXPECT_EQ(parse(first + second + std::string(512, '\0'), "a.obj.gz").vertices.size(), 3U);
  const MeshFileError e = error_of(first + second + "more", "a.obj.gz");
  EXPECT_EQ(e.problem, MeshFileProblem::syntax);
  EXPECT_EQ(e.byte, first.size() + second.size());
}

TEST(Gzip, CutAnywhereIsRefused) {
  const std::string packed = gzipped(sample_files().front().bytes);
  for (std::size_t size = 2; size < packed.size(); ++size) {
    const MeshFileError e = error_of(packed.substr(0, size), "cut.obj.gz");
    EXPECT_EQ(e.problem, MeshFileProblem::truncated) << size;
    EXPECT_THAT(e.what(), StartsWith("cut.obj.gz: byte "));
  }
}

TEST(Gzip, DamagedAnywhereIsRefusedOrHarmless) {
  const std::string plain = sample_files().front().bytes, packed = gzipped(plain);
  const PolygonMesh expected = parse(plain, "a.obj");
  int refused = 0;
  for (std::size_t at = 0; at < packed.size(); ++at) {
    std::string damaged = packed;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    try {
      EXPECT_EQ(parse(damaged, "a.obj.gz").vertices, expected.vertices) << at;  // as in the header's time stamp
    } catch (const MeshFileError&) {
      ++refused;
    }
  }
  EXPECT_GE(refused, static_cast<int>(packed.size()) - 10);
}

TEST(Gzip, ABombMeetsTheLimits) {
  const std::string face = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::string bomb = gzipped(face + std::string(std::size_t{64} << 20, ' '));
  ASSERT_LT(bomb.size(), 100'000U);
  const MeshFileError e = error_of(bomb, "bomb.obj.gz");
  EXPECT_EQ(e.problem, MeshFileProblem::too_large);
  EXPECT_THAT(e.what(), AllOf(StartsWith("bomb.obj.gz: unpacks to more than "), HasSubstr("raise the limit")));
  EXPECT_EQ(parse(bomb, "bomb.obj.gz", {.most_ratio = 2000}).corners.size(), 3U);
  const std::uint64_t size = face.size() + (std::uint64_t{64} << 20);
  EXPECT_EQ(parse(bomb, "b.obj.gz", {.most_bytes = size, .most_ratio = ~0ULL}).corners.size(), 3U);
  EXPECT_EQ(error_of(bomb, "b.obj.gz", {.most_bytes = size - 1, .most_ratio = ~0ULL}).problem,
            MeshFileProblem::too_large);
  // The bomb within a bomb is no mesh.
  EXPECT_EQ(error_of(gzipped(bomb), "b.gz.gz").problem, MeshFileProblem::unknown_format);
  EXPECT_EQ(error_of(gzipped(""), "nothing.obj.gz").problem, MeshFileProblem::empty_file);
}

TEST(ForeignFormats, AreNamedWithWhatConvertsThem) {
  struct Foreign {
    std::string name, bytes, said;
  };
  const std::string iges_line = "plumb test" + std::string(62, ' ') + "S      1\n";
  for (const Foreign& f : std::vector<Foreign>{
           {"a.STEP", "x", "STEP"},
           {"a.stp", "ISO-10303-21;\n", "STEP"},
           {"a", "ISO-10303-21;\n", "STEP"},
           {"a.igs", "x", "IGES"},
           {"a", iges_line, "IGES"},
           {"a.sldprt", "x", "SolidWorks"},
           {"a.dwg", "AC1032", "DWG"},
           {"a.fbx", "Kaydara FBX Binary  ", "FBX"},
           {"a.obj", "BLENDER-v300", "Blender"},
           {"a.dae", "<COLLADA>", "COLLADA"},
           {"a.wrl", "#VRML V2.0 utf8\n", "VRML"},
           {"a.usdz", "x", "USD"},
           {"a.vtk", "# vtk DataFile Version 3.0\n", "VTK"},
       }) {
    for (const bool packed : {false, true}) {
      const std::string name = packed ? f.name + ".gz" : f.name;
      const MeshFileError e = error_of(packed ? gzipped(f.bytes) : f.bytes, name);
      EXPECT_EQ(e.problem, MeshFileProblem::unknown_format) << name;
      EXPECT_THAT(e.what(), StartsWith(name + ": this is " + f.said)) << name;
    }
  }
  EXPECT_THAT(error_of("hello", "a.xyz").what(), HasSubstr("neither the name nor the content"));
}

}  // namespace
}  // namespace plumb
