// White space does not matter where a format is of words: however it is laid out, a file reads to the same mesh.  What is
// broken is refused with the line that shows it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "plumb/surface/file/read_mesh.hpp"
#include "surface/file/sample_files.hpp"

namespace plumb {
namespace {

using enum MeshFileProblem;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

PolygonMesh read(const std::string& bytes, MeshFormat format, LoadReport* report = nullptr) {
  return parse_mesh(bytes, format, "part.x", report);
}

std::string error_of(const std::string& bytes, MeshFormat format, MeshFileProblem problem) {
  try {
    read(bytes, format);
  } catch (const MeshFileError& e) {
    EXPECT_EQ(e.problem, problem) << e.what();
    return e.what();
  }
  ADD_FAILURE() << "was read: " << bytes;
  return "";
}

std::string facet(const std::string& corners) {
  return "facet normal 0 0 0 outer loop " + corners + " endloop endfacet ";
}
const std::string low = facet("vertex 0 0 0 vertex 1 0 0 vertex 0 1 0");
const std::string high = facet("vertex 0 0 0 vertex 0 1 0 vertex 0 0 1");

TEST(FlowingWords, FacetsOfStlMayStandOnAnyLine) {
  const auto facets = [](const std::string& bytes) {
    LoadReport report;
    read(bytes, MeshFormat::stl, &report);
    EXPECT_THAT(report.passed_over, testing::IsEmpty());
    return report.faces;
  };
  EXPECT_EQ(facets("solid x " + low + "\n" + high + "\nendsolid x\n"), 2U);
  EXPECT_EQ(facets("solid x " + low + "\nendsolid x\n"), 1U);
  EXPECT_EQ(facets("solid " + low + high + "endsolid"), 2U);
  EXPECT_EQ(facets("solid a part of two " + low + "endsolid a part of two solid b " + high + "endsolid b"), 2U);
  EXPECT_EQ(facets("solid a\n" + low + "endsolid a solid b\n" + high + "endsolid b\n"), 2U);
  EXPECT_EQ(facets("solid a " + low + "endsolid a solid b endsolid b\nsolid " + high + "endsolid"), 2U);
  EXPECT_EQ(facets("solid solid endsolid facet\n" + low + "endsolid solid facet solid\nsolid\n" + high + "endsolid"),
            2U);
  EXPECT_EQ(facets("SOLID x FACET\n\tNORMAL " + low.substr(13) + "endSolid"), 1U);
  EXPECT_THAT(error_of("solid x\n" + low + "endsolid x " + high + "endsolid", MeshFormat::stl, syntax),
              AllOf(StartsWith("part.x:2: "), HasSubstr("found \"facet\", expected `solid`")));
  EXPECT_THAT(error_of("solid x facet normal\n", MeshFormat::stl, truncated), HasSubstr("the facet's normal"));
  EXPECT_THAT(error_of("solid x\n" + low + "endsolid x\nsolid y\n", MeshFormat::stl, truncated),
              HasSubstr("expected `facet` or `endsolid`"));
}

TEST(FlowingWords, NumbersOfOffMayStandOnAnyLine) {
  LoadReport report;
  const PolygonMesh two = read("OFF 4 1 0\n0 0 0 1 0 0\n0 1 0 0 0 1\n3 0 1 2\n", MeshFormat::off, &report);
  EXPECT_EQ(two.vertices, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(two.corners, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_THAT(report.passed_over, testing::IsEmpty());
  for (const char* const same :
       {"OFF 4 2 0 0 0 0 1 0 0 0 1 0 0 0 1 3 0 1 2 3 0 2 3",
        "OFF\n4\n2\n0\n0 0 0\n1 0 0\n0 1\n0\n0 0 1\n3 0\n1 2 3 0 2 3\n",
        "OFF\n4 2 0\n0 0 0 1 0\n0 0 1 0 0 0 1\n3 0 1 2 255 0 0\n3 0 2\n3 0 255 0 9\n",
        "CNOFF 4 2 0\n0 0 0 0 0 1 9 9 9 1 1 0 0 0 0 1 9 9 9 1\n0 1 0 0 0 1 9 9 9 1\n0 0 1 0 0 1 9 9 9 1\n3 0 1 2 3 0 2 "
        "3\n",
        "COFF 4 2 0 0 0 0 9 9 9 1 0 0 9 9 9\n0 1 0 9 9 9 0 0 1 9 9 9\n3 0 1 2 7\n3 0 2 3 7\n"}) {
    const PolygonMesh mesh = read(same, MeshFormat::off, &report);
    EXPECT_EQ(mesh.vertices, two.vertices) << same;
    EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3})) << same;
    EXPECT_THAT(report.passed_over, testing::IsEmpty()) << same;
  }
  // A missing number is told where it is missing, not where numbers come to their end.
  EXPECT_THAT(error_of("OFF\n4 2 0\n0 0 0\n1 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 2 3\n", MeshFormat::off, syntax),
              StartsWith("part.x:4: the line ends where coordinate z"));
  EXPECT_THAT(error_of("OFF 4 1 0\n0 0 0 1 0 0\n0 1 0 0 0 1\n3 0 1\n", MeshFormat::off, syntax),
              StartsWith("part.x:4: the line ends where a vertex number was expected; "));
}

TEST(FlowingWords, NumbersOfAsciiPlyMayStandOnAnyLine) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (const char* const same : {"0 0\n0 1 0 0\n0 1 0\n0 0 1 3\n0 1\n2\n", "0 0 0 1 0 0 0 1 0 0 0 1 3 0 1 2",
                                 "\n0\n0\n0\n1 0 0\r\n0 1 0 0\r0 1 3 0 1 2"}) {
    const PolygonMesh mesh = read(head + same, MeshFormat::ply);
    EXPECT_EQ(mesh.vertices, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})) << same;
    EXPECT_EQ(mesh.corners, (std::vector<std::uint32_t>{0, 1, 2})) << same;
  }
  EXPECT_THAT(error_of(head + "0 0 0\n1 0\n0 1 0\n0 0 1\n3 0 1 2\n", MeshFormat::ply, syntax),
              AllOf(StartsWith("part.x:11: the line ends where coordinate z was expected"), HasSubstr("in line 14: ")));
  EXPECT_THAT(error_of(head + "0 0 0 7\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n", MeshFormat::ply, syntax),
              AllOf(StartsWith("part.x:10: found \"7\" after the properties"), HasSubstr("in line 14: ")));
  EXPECT_THAT(error_of(head + "0 0\n0 1 0 nan\n0 1 0\n0 0 1 3\n0 1\n2\n", MeshFormat::ply, bad_number),
              StartsWith("part.x:11: coordinate z is \"nan\""));
}

/// White space that means the same as a blank: no more than that is changed.
class WhiteSpace {
 public:
  explicit WhiteSpace(unsigned seed) : random_(seed) {}
  std::string blank() { return one_of({" ", "  ", "\t", " \t ", "\v", "\f "}); }
  std::string line_end() { return one_of({"\n", "\r\n", "\r", "\n\n", " \n", "\r\n\t", "\n \n "}); }
  /// Anywhere between words; mostly blanks, mostly line ends or as it comes.
  std::string between() {
    if (round_ % 17 == 0) habit_ = random_() % 3;
    ++round_;
    return random_() % 4 < 2 * habit_ ? line_end() : blank();
  }
  std::string with(const std::vector<std::string>& words) {
    std::string text = words.front();
    for (std::size_t i = 1; i < words.size(); ++i) text += between() + words[i];
    return text;
  }
  std::string one_of(const std::vector<std::string>& all) { return all[random_() % all.size()]; }

 private:
  std::mt19937 random_;
  std::mt19937::result_type round_ = 0, habit_ = 0;
};

/// A strip of triangles with a polygon at its end, whose numbers are not all small.
PolygonMesh sample() {
  PolygonMesh mesh{{}, {}, {0}};
  for (std::uint32_t i = 0; i < 12; ++i) mesh.vertices.push_back({0.5 * (i % 2), 1.0 * (i / 2), i == 7 ? -0.25 : 0});
  for (std::uint32_t i = 0; i < 10; ++i) {
    for (std::uint32_t k = 0; k < 3; ++k) mesh.corners.push_back(i % 2 == 0 ? i + k : i + 2 - k);
    mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  }
  mesh.corners.insert(mesh.corners.end(), {0, 2, 4, 6, 7, 5, 3, 1});
  mesh.first.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
  return mesh;
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t at = text.find_first_not_of(" \n"); at != std::string::npos;
       at = text.find_first_not_of(" \n", at)) {
    const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

void expect_same(const std::string& bytes, MeshFormat format, const PolygonMesh& expected, unsigned seed) {
  for (const Strictness strictness : {Strictness::strict, Strictness::usual, Strictness::lenient}) {
    try {
      const PolygonMesh mesh = parse_mesh(bytes, format, "x", nullptr, {.strictness = strictness});
      EXPECT_TRUE(mesh.vertices == expected.vertices && mesh.corners == expected.corners &&
                  mesh.first == expected.first)
          << "seed " << seed << ":\n"
          << bytes;
    } catch (const MeshFileError& e) {
      ADD_FAILURE() << "seed " << seed << ": " << e.what() << "\n" << bytes;
    }
  }
}

constexpr unsigned layouts = 300;

TEST(FlowingWords, StlReadsTheSameInEveryLayout) {
  const std::string text = format_mesh(sample(), MeshFormat::stl);
  const PolygonMesh expected = read(text, MeshFormat::stl);
  const std::vector<std::string> plain =
      words_of(text.substr(text.find("facet"), text.rfind("endsolid") - text.find("facet")));
  for (unsigned seed = 0; seed < layouts; ++seed) {
    WhiteSpace space(seed);
    // A name is on the line of its word; the facets are of one solid or two.
    std::vector<std::string> words = plain;
    if (seed % 2 == 0) {
      std::size_t facet_at = 0;
      for (std::size_t i = 0, n = 0; i < words.size() && n < 4; ++i)
        if (words[i] == "facet" && ++n == 4) facet_at = i;
      words.insert(words.begin() + static_cast<std::ptrdiff_t>(facet_at),
                   {"endsolid" + space.blank() + "the" + space.blank() + "lid", "solid" + space.blank() + "b"});
    }
    words.insert(words.begin(), "solid" + (seed % 3 == 0 ? "" : space.blank() + "a" + space.blank() + "b"));
    words.push_back("endsolid" + (seed % 5 == 0 ? "" : space.blank() + "a"));
    expect_same(space.with(words), MeshFormat::stl, expected, seed);
  }
}

TEST(FlowingWords, PlyReadsTheSameInEveryLayout) {
  const std::string text = format_mesh(sample(), MeshFormat::ply, MeshEncoding::ascii);
  const std::size_t body = text.find("end_header\n") + 11;
  for (unsigned seed = 0; seed < layouts; ++seed) {
    WhiteSpace space(seed);
    expect_same(text.substr(0, body) + space.with(words_of(text.substr(body))), MeshFormat::ply, sample(), seed);
  }
}

TEST(FlowingWords, OffReadsTheSameInEveryLayout) {
  const PolygonMesh mesh = sample();
  for (unsigned seed = 0; seed < layouts; ++seed) {
    WhiteSpace space(seed);
    const auto between = [&] {
      return seed % 3 == 0 && space.one_of({"", "x"}).empty() ? "# 1 2 3\n" : space.between();
    };
    std::string text = "OFF" + between() + std::to_string(mesh.vertices.size()) + between() + "11" + between() + "0";
    for (const Point3& p : mesh.vertices)
      for (const double x : {p.x, p.y, p.z}) text += between() + testing::PrintToString(x);
    const bool colored = seed % 2 == 0;  // then each face begins a line, and its color is on the last of its lines
    for (std::size_t f = 0; f + 1 < mesh.first.size(); ++f) {
      text += colored ? space.line_end() : between();
      text += std::to_string(mesh.first[f + 1] - mesh.first[f]);
      for (std::size_t k = mesh.first[f]; k < mesh.first[f + 1]; ++k)
        text += between() + std::to_string(mesh.corners[k]);
      if (colored) text += space.blank() + space.one_of({"3", "0.5 0.5 0.5", "255 0 0 1"});
    }
    expect_same(text, MeshFormat::off, mesh, seed);
  }
}

// OBJ is of lines; blanks, line ends, comments and continued lines are free.
TEST(FlowingWords, ObjReadsTheSameWithAnyBlanksAndComments) {
  const std::string text = format_mesh(sample(), MeshFormat::obj);
  for (unsigned seed = 0; seed < layouts; ++seed) {
    WhiteSpace space(seed);
    std::string changed;
    for (const char c : text) {
      if (c == ' ') {
        changed += space.one_of({space.blank(), space.blank(), " \\\n", "\\\r\n "});
      } else if (c == '\n') {
        changed += space.one_of({"", "", " # f 1 2 3", "\t"}) + space.line_end() +
                   space.one_of({"", "", " ", "# v\n", "g x\n"});
      } else {
        changed += c;
      }
    }
    expect_same(changed, MeshFormat::obj, sample(), seed);
  }
}

}  // namespace
}  // namespace plumb
