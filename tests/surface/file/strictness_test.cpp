// What is passed over in a file, and what is refused, in each of the ways to read it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "plumb/surface/file/read_mesh.hpp"
#include "surface/file/packages.hpp"
#include "surface/file/sample_files.hpp"

namespace plumb {
namespace {

using surface_test::raw;
using testing::HasSubstr;
using testing::IsEmpty;

struct Read {
  PolygonMesh mesh;
  LoadReport report;
  std::string error;  // empty where it was read
};

Read read(const std::string& bytes, MeshFormat format, Strictness strictness) {
  Read r;
  try {
    r.mesh = parse_mesh(bytes, format, "part.x", &r.report, {.strictness = strictness});
  } catch (const MeshFileError& e) {
    r.error = e.what();
    EXPECT_TRUE(e.line.has_value() || e.byte.has_value()) << r.error;
    EXPECT_THAT(r.error, testing::StartsWith("part.x:"));
  }
  return r;
}

/// A file that the strictest of these ways takes, and what it passes over then.
struct Case {
  std::string bytes;
  MeshFormat format;
  std::uint64_t faces;
  std::string what;
  std::uint64_t count;
  std::optional<std::uint64_t> line, byte;
  std::string first;
};

void expect_passed_over(const Case& c, Strictness taking) {
  SCOPED_TRACE(c.bytes);
  for (const Strictness strictness : {Strictness::strict, Strictness::usual, Strictness::lenient}) {
    const Read r = read(c.bytes, c.format, strictness);
    if (strictness < taking) {
      EXPECT_NE(r.error, "");
      continue;
    }
    EXPECT_EQ(r.error, "");
    EXPECT_EQ(r.report.faces, c.faces);
    ASSERT_EQ(r.report.passed_over.size(), 1U);
    const PassedOver& p = r.report.passed_over.front();
    EXPECT_THAT(p.what, HasSubstr(c.what));
    EXPECT_EQ(p.count, c.count);
    EXPECT_EQ(p.line, c.line);
    EXPECT_EQ(p.byte, c.byte);
    EXPECT_THAT(p.first, HasSubstr(c.first));
  }
}

TEST(Strictness, SoundFilesReadAlikeAndNothingIsPassedOver) {
  for (const auto& file : surface_test::sample_files()) {
    SCOPED_TRACE(file.name);
    const Read usual = read(file.bytes, file.format, Strictness::usual);
    for (const Strictness strictness : {Strictness::strict, Strictness::lenient}) {
      const Read r = read(file.bytes, file.format, strictness);
      EXPECT_EQ(r.error, "");
      EXPECT_EQ(r.mesh.vertices, usual.mesh.vertices);
      EXPECT_EQ(r.mesh.corners, usual.mesh.corners);
      EXPECT_THAT(r.report.passed_over, IsEmpty());
    }
  }
}

const std::string corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(Strictness, LinesThatAreNoStatementOfObjAreCountedOrRefused) {
  const auto obj = [](const std::string& bytes, const std::string& what, std::uint64_t count, std::uint64_t line,
                      const std::string& first) {
    expect_passed_over({bytes, MeshFormat::obj, 1, what, count, line, {}, first}, Strictness::usual);
  };
  obj(corner + "f 1 2 3\nf1 2 3\n", "no statement of OBJ", 1, 5, "\"f1 2 3\"");
  obj(corner + "F 1 2 3\nf 1 2 3\n\nv1 2 3\nV 1 2 3\n", "no statement of OBJ", 3, 4, "\"F 1 2 3\"");
  obj(corner + "f 1 2 3\nsurf 0 1 0 1 1 2 3\n", "no statement of OBJ", 1, 5, "\"surf 0 1 0 1 1 2 3\"");
  obj("v 0 0 0 v 1 0 0\nv 0 1 0\nf 1 2 2\n", "behind a vertex", 1, 1, "\"v 1 0 0\"");
  obj("v 0 0 0 1 2\nv 1 0 0 red\nv 0 1 0 1 1 1 1 1\nf 1 2 3\n", "behind a vertex", 3, 1, "\"1 2\"");
  const Read strict = read(corner + "f 1 2 3\nf1 2 3\n", MeshFormat::obj, Strictness::strict);
  EXPECT_EQ(
      strict.error,
      "part.x:5: found \"f1 2 3\", expected a file without lines that are no statement of OBJ; mend or delete it, or "
      "read less strictly");
  const std::string known =
      "mtllib a.mtl\no part\ng a b\ns off\nvt 0 0\nvn 0 0 1\nvp 0\nusemtl x\nl 1 2\np 1\nlod 1\nv 0 0 0 1\nv 1 0 0 .5 "
      ".5 "
      ".5\nv 0 1 0 1 0 0 1\nf 1 2 3\n";
  EXPECT_EQ(read(known, MeshFormat::obj, Strictness::strict).error, "");
}

TEST(Strictness, TextsOfOffThatMeanNothingAreCountedOrRefused) {
  const auto off = [](const std::string& bytes, const std::string& what, std::uint64_t count, std::uint64_t line,
                      const std::string& first) {
    expect_passed_over({bytes, MeshFormat::off, 1, what, count, line, {}, first}, Strictness::usual);
  };
  off("OFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 0 0 0\n3 0 1 2\n", "behind a vertex", 3, 3, "\"255 0 0\"");
  off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 red\n", "behind a face", 1, 6, "\"red\"");
  off("OFF\n3 1 0 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "behind the counts", 1, 2, "\"0\"");
}

TEST(Strictness, ALineThatABackslashTakesIntoANameIsTold) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const std::string name : {"o", "g", "usemtl", "mtllib"})
    expect_passed_over({points + name + " C:\\parts\\\nv 0 0 1\nf 1 2 3\n",
                        MeshFormat::obj,
                        1,
                        "joined to a name by a backslash",
                        1,
                        4,
                        {},
                        "v 0 0 1"},
                       Strictness::usual);
  EXPECT_TRUE(read(points + "f 1 \\\n2 3\no a\\b\n", MeshFormat::obj, Strictness::strict).report.passed_over.empty());
}

TEST(Strictness, CornersWithNothingBehindASlashAreReadLeniently) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const std::string written : {"1/", "1/1/", "1//"})
    expect_passed_over(
        {points + "f " + written + " 2 3\n", MeshFormat::obj, 1, "nothing behind a slash", 1, 4, {}, written},
        Strictness::lenient);
}

TEST(Strictness, APlyMayHaveEachNumberOnALineOfItsOwn) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0\n0\n0\n1\n0\n0\n0\n1\n0\n3\n0\n1\n2\n";
  for (const Strictness strictness : {Strictness::strict, Strictness::usual, Strictness::lenient}) {
    const Read r = read(ply, MeshFormat::ply, strictness);
    EXPECT_EQ(r.error, "");
    EXPECT_EQ(r.report.faces, 1U);
    EXPECT_TRUE(r.report.passed_over.empty());
  }
}

std::string facet_of(const std::string& begin, const std::string& corners) {
  return " " + begin + "\n  outer loop\n" + corners + "  endloop\n endfacet\n";
}
const std::string low = "   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n",
                  high = "   vertex 0 0 0\n   vertex 0 1 0\n   vertex 0 0 1\n";
const std::string low_facet = facet_of("facet normal 0 0 0", low), high_facet = facet_of("facet normal 0 0 0", high);

TEST(Strictness, WhatOthersReadOfTextStlIsReadLeniently) {
  const auto stl = [](const std::string& bytes, const std::string& what, std::uint64_t count, std::uint64_t line,
                      const std::string& first) {
    expect_passed_over({bytes, MeshFormat::stl, 2, what, count, line, {}, first}, Strictness::lenient);
  };
  const std::string both = low_facet + high_facet, end = "endsolid x\n";
  stl("solid x\n" + both, "without `endsolid`", 1, 15, "the file ends");
  stl("solid x\n" + low_facet + "solid y\n" + high_facet + end, "without `endsolid`", 1, 9, "\"solid y\"");
  stl("solid x\n" + low_facet + end + high_facet + end, "without `solid`", 1, 10, "\"facet normal 0 0 0\"");
  stl("solid x\n" + both + "color 1 0 0\n" + end, "lines among the facets", 1, 16, "\"color 1 0 0\"");
  stl("solid x\n" + both + "color 1 0 0\nmaterial facet\n" + end + "the end\n", "lines among the facets", 3, 16,
      "\"color 1 0 0\"");
  stl("solid x\n" + low_facet + "color 1 0 0 " + high_facet.substr(1) + end, "lines among the facets", 1, 9,
      "\"color 1 0 0");
  stl("solid x\n" + both + "end solid x\n", "blanks within a word", 1, 16, "\"end\"");
  std::string in_two_words = both;
  for (const std::string word : {"loop", "facet"}) {
    for (std::size_t at = 0; (at = in_two_words.find("end" + word, at)) != std::string::npos;)
      in_two_words.insert(at + 3, 1, ' ');
  }
  stl("solid x\n" + in_two_words + end, "blanks within a word", 4, 7, "\"end\"");
  stl("solid x\n" + facet_of("facet", low) + facet_of("facet", high) + end, "without a normal", 2, 2, "\"facet\"");
  stl("solid x\n" + low_facet + facet_of("facet normal", high) + end, "without a normal", 1, 9, "\"facet normal\"");
  for (const std::string& broken : {"solid x\n" + low_facet + " facet normal 0 0 0\n  outer loop\n" + low,
                                    "solid x\n" + facet_of("facet", "   vertex 0 0 0\n   vertex 1 0 0\n") + end})
    EXPECT_NE(read(broken, MeshFormat::stl, Strictness::lenient).error, "") << broken;
}

TEST(Strictness, WhatOthersReadOfBinaryStlIsReadLeniently) {
  std::string facets;
  for (const std::vector<float>& t : {std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 1, 0, 0, 0, 1}}) {
    facets += std::string(12, '\0');
    for (const float x : t) facets += raw(x);
    facets += std::string(2, '\0');
  }
  const auto with_count = [](std::uint32_t count) { return std::string(80, 'x') + raw(count); };
  const auto stl = [](const std::string& bytes, std::uint64_t faces, const std::string& what, std::uint64_t byte,
                      const std::string& first) {
    expect_passed_over({bytes, MeshFormat::stl, faces, what, 1, {}, byte, first}, Strictness::lenient);
  };
  stl(with_count(2) + facets + "x", 2, "behind the last facet", 184, "1 byte");
  stl(with_count(1) + facets + "x", 1, "behind the last facet", 134, "51 bytes");
  stl(with_count(1) + facets, 2, "counts of facets", 80, "1, where there are 2");
  stl(with_count(7) + facets, 2, "counts of facets", 80, "7, where there are 2");
  // Text is no STL, however much of it there is.
  EXPECT_NE(read(std::string(500, 'x'), MeshFormat::stl, Strictness::lenient).error, "");
}

TEST(Strictness, CountsThatAreWrongAndWhatFollowsThemAreReadLeniently) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  expect_passed_over({"OFF\n3 1 0\n" + points + "3 0 1 2\nmade by hand\n3 0 1 2\n",
                      MeshFormat::off,
                      1,
                      "behind the last face",
                      2,
                      7,
                      {},
                      "\"made by hand\""},
                     Strictness::lenient);
  expect_passed_over({"OFF\n3 9 0\n" + points + "3 0 1 2\n",
                      MeshFormat::off,
                      1,
                      "counts in the header",
                      1,
                      {},
                      36,
                      "9 faces, where there are 1"},
                     Strictness::lenient);
  const auto ply = [&](const std::string& format, const std::string& faces) {
    return "ply\nformat " + format + " 1.0\nelement vertex 3\nproperty char x\nproperty char y\nproperty char z\n" +
           "element face " + faces + "\nproperty list uchar uchar vertex_indices\nend_header\n";
  };
  expect_passed_over({ply("ascii", "1") + points + "3 0 1 2\n3 0 1 2\n",
                      MeshFormat::ply,
                      1,
                      "behind the last element",
                      1,
                      14,
                      {},
                      "\"3 0 1 2\""},
                     Strictness::lenient);
  expect_passed_over({ply("ascii", "1") + "0 0 0 9\n1 0 0 9\n0 1 0\n3 0 1 2\n",
                      MeshFormat::ply,
                      1,
                      "behind an element",
                      2,
                      10,
                      {},
                      "\"9\""},
                     Strictness::lenient);
  const std::string few = ply("ascii", "4") + points + "3 0 1 2\n";
  expect_passed_over(
      {few, MeshFormat::ply, 1, "counts in the header", 1, {}, few.size(), "4 of \"face\", where there are 1"},
      Strictness::lenient);
  for (const char* const format : {"binary_little_endian", "binary_big_endian"}) {
    const std::string bytes("\0\0\0\1\0\0\0\1\0\3\0\1\2", 13), one = ply(format, "1") + bytes,
                                                               four = ply(format, "4") + bytes;
    expect_passed_over({one + "\1more", MeshFormat::ply, 1, "behind the last element", 1, {}, one.size(), "5 bytes"},
                       Strictness::lenient);
    expect_passed_over({four, MeshFormat::ply, 1, "counts in the header", 1, {}, four.size(), "4 of \"face\""},
                       Strictness::lenient);
  }
  // Where vertices are missing, what stands for them is none.
  for (const std::string& broken :
       {"OFF\n4 1 0\n" + points + "3 0 1 2\n", ply("ascii", "1") + "0 0 0\n1 0 0\n", ply("ascii", "2") + points,
        ply("binary_little_endian", "2") + std::string(9, '\0')})
    EXPECT_NE(read(broken, broken[0] == 'O' ? MeshFormat::off : MeshFormat::ply, Strictness::lenient).error, "")
        << broken;
}

TEST(Strictness, WhatFollowsAGlbIsReadLeniently) {
  const std::string document =
      R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36}]})";
  const std::string glb = surface_test::glb_of(
      document, std::string(12, '\0') + raw(1.0F) + std::string(12, '\0') + raw(1.0F) + std::string(4, '\0'));
  expect_passed_over({glb + "!", MeshFormat::gltf, 1, "behind the last chunk", 1, {}, glb.size(), "1 byte"},
                     Strictness::lenient);
}

}  // namespace
}  // namespace plumb
