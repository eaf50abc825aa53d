// Does `plumb intersect` find the pairs of triangles that meet, say and write them, and refuse what it cannot do?
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>

#include "figure/basic/solids.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/matchers.hpp"
#include "tool/mesh/triangles_obj.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

/// A triangle, and one that stands across it.
constexpr auto crossed = "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 -1\nv 1 1 1\nv 1 2 0\nf 1 2 3\nf 4 5 6\n";
constexpr auto beside = "v 4 0 0\nv 8 0 0\nv 8 0.1 9\nf 1 2 3\n";

std::string in(const Folder& folder) {
  std::ofstream(folder / "crossed.obj") << crossed;
  std::ofstream(folder / "beside.obj") << beside;
  return "cd " + (folder / "") + " && $PLUMB intersect ";
}

TEST(Intersect, SaysWhichTrianglesOfAMeshMeet) {
  const Folder folder;
  const Outcome o = run(in(folder) + "--common crossed.obj");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out,
            "crossed.obj: 6 vertices, 2 triangles, not closed\n"
            "1 pair of triangles meets: 0 touch, 1 overlaps\n"
            "  triangle   triangle         in common\n"
            "         0          1 overlap segment 1 1 0, 1 2 0\n");
  EXPECT_THAT(run(in(folder) + "beside.obj").out, HasSubstr("closed\nno two triangles meet\n"));
}

TEST(Intersect, OfTwoMeshesTellsTouchingFromOverlapping) {
  const Folder folder;
  const std::string at = in(folder);
  EXPECT_THAT(run(at + "crossed.obj beside.obj").out, HasSubstr("1 pair of triangles meets: 1 touches, 0 overlap\n"
                                                                "      of a       of b\n"
                                                                "         0          0 touch\n"));
  EXPECT_THAT(run(at + "crossed.obj beside.obj --overlapping").out, HasSubstr("no two triangles overlap\n"));
  EXPECT_THAT(run(at + "crossed.obj crossed.obj").out, HasSubstr("4 pairs of triangles meet: 0 touch, 4 overlap\n"));
  EXPECT_THAT(run(at + "crossed.obj - <beside.obj").out, HasSubstr("standard input: 3 vertices"));
}

TEST(Intersect, JsonHoldsThePairsOfTheLibrary) {
  const Folder folder;
  TriangleMesh a = solids::box({0, 0, 0}, {8, 8, 8}), b = solids::box({8, 4, 2}, {12, 9, 9});
  solids::append(a, solids::box({-1, 3, 3}, {9, 5, 5}));
  write_mesh(folder / "a.obj", a);
  write_mesh(folder / "b.obj", b);
  const Bvh tree_a = build_bvh(a), tree_b = build_bvh(b);
  const auto expect_pairs = [&](const std::string& files, const std::vector<TrianglePair>& pairs) {
    const json said = json::parse(run("cd " + (folder / "") + " && $PLUMB intersect --common --json - " + files).out);
    EXPECT_EQ(said.at("program"), "plumb intersect");
    EXPECT_EQ(said.at("meet"), true);
    ASSERT_EQ(said.at("pairs").size(), pairs.size());
    std::size_t overlapping = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const json& pair = said.at("pairs")[i];
      const bool overlaps = pairs[i].relation == Relation::overlapping;
      overlapping += overlaps ? 1 : 0;
      EXPECT_EQ(pair.at("a"), pairs[i].a);
      EXPECT_EQ(pair.at("b"), pairs[i].b);
      EXPECT_EQ(pair.at("relation"), overlaps ? "overlapping" : "touching");
      const std::size_t points = pair.at("in_common").at("corners").size();
      const std::string kind = pair.at("in_common").at("kind");
      EXPECT_EQ(kind, points == 1 ? "point" : points == 2 ? "segment" : "polygon");
    }
    EXPECT_EQ(said.at("overlapping"), overlapping);
    EXPECT_EQ(said.at("touching"), pairs.size() - overlapping);
    const json counted = json::parse(run("cd " + (folder / "") + " && $PLUMB intersect --count --json - " + files).out);
    EXPECT_EQ(counted.at("overlapping"), overlapping);
    EXPECT_EQ(counted.at("touching"), pairs.size() - overlapping);
    EXPECT_FALSE(counted.contains("pairs"));
    const json first = json::parse(run("cd " + (folder / "") + " && $PLUMB intersect --first --json - " + files).out);
    EXPECT_EQ(first.at("pairs").size(), 1u);
    EXPECT_FALSE(first.contains("overlapping"));
  };
  expect_pairs("a.obj", intersecting_pairs(tree_a));
  expect_pairs("a.obj b.obj", intersecting_pairs(tree_a, tree_b));
}

TEST(Intersect, ListsTheFirstTenOrAll) {
  const Folder folder;
  TriangleMesh mesh = solids::box({0, 0, 0}, {8, 8, 8});
  solids::append(mesh, solids::box({0, 0, 0}, {8, 8, 8}));  // the same again, of other vertices
  write_mesh(folder / "twice.obj", mesh);
  const std::string line = "$PLUMB intersect " + (folder / "twice.obj");
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  const Outcome few = run(line), all = run(line + " --all");
  EXPECT_EQ(lines(few.out), 3 + 10 + 2);
  EXPECT_THAT(few.out, AllOf(HasSubstr(" more; --all lists them\n"),
                             HasSubstr("8 vertices lie where another is: triangles that meet there share none")));
  const std::size_t pairs = intersecting_pairs(build_bvh(mesh)).size();
  EXPECT_EQ(lines(all.out), static_cast<std::ptrdiff_t>(3 + pairs + 1));
}

TEST(Intersect, ExitsWithOneWhereAskedAndFound) {
  const Folder folder;
  const std::string at = in(folder);
  EXPECT_EQ(run(at + "--fail-on-found beside.obj").code, 0);
  EXPECT_EQ(run(at + "--fail-on-found --overlapping crossed.obj beside.obj").code, 0);
  for (const std::string how : {"", "--first ", "--count "}) {
    const Outcome o = run(at + "-q --fail-on-found " + how + "crossed.obj");
    EXPECT_EQ(o.code, 1) << how;
    EXPECT_EQ(o.out + o.err, "") << how;
  }
  EXPECT_EQ(run(at + "--fail-on-found crossed.obj --json r.json").code, 1);  // and writes what it found
  EXPECT_THAT(content(folder / "r.json"), HasSubstr("overlapping"));
}

TEST(Intersect, WritesTheTrianglesAsObj) {
  const Folder folder;
  const std::string at = in(folder);
  EXPECT_EQ(run(at + "crossed.obj beside.obj --obj met.obj").code, 0);
  EXPECT_EQ(content(folder / "met.obj"),
            "# plumb intersect: the triangles of crossed.obj (a) and beside.obj (b) that meet\n"
            "o a-touching\nv 0 0 0\nv 4 0 0\nv 0 4 0\n# 0\nf 1 2 3\n"
            "o b-touching\nv 4 0 0\nv 8 0 0\nv 8 0.1 9\n# 0\nf 4 5 6\n");
  const Outcome there = run(at + "crossed.obj --obj met.obj");
  EXPECT_EQ(there.code, 2);
  EXPECT_THAT(there.err, HasSubstr("met.obj is there already and is kept; give another name, or --overwrite"));
  EXPECT_THAT(content(folder / "met.obj"), HasSubstr("beside.obj"));
  EXPECT_EQ(run(at + "crossed.obj --obj met.obj --overwrite").code, 0);
  EXPECT_EQ(read_mesh(folder / "met.obj").triangles.size(), 2u);
  const Outcome own = run(at + "crossed.obj --obj crossed.obj --overwrite");
  EXPECT_EQ(own.code, 2);
  EXPECT_THAT(own.err, HasSubstr("--obj would replace crossed.obj, which this run reads"));
  EXPECT_EQ(content(folder / "crossed.obj"), crossed);
  EXPECT_THAT(run(at + "crossed.obj --obj").out, StartsWith("# plumb intersect: the triangles of crossed.obj"));
}

TEST(TrianglesObj, KeepsEveryBitAndTakesVerticesOnce) {
  const TriangleMesh mesh{{{0.1, 1e-300, -0.0}, {1e300, 5e-324, 1.0 / 3}, {7, 8, 9}, {1, 2, 3}, {4, 5, 6}},
                          {{0, 1, 3}, {2, 1, 4}, {3, 1, 4}}};
  const std::vector<TriangleGroup> groups{{"none", &mesh, {}}, {"some", &mesh, distinct({2, 0, 2})}};
  const Folder folder;
  std::ofstream(folder / "some.obj") << triangles_obj("about\nit", groups);
  EXPECT_THAT(content(folder / "some.obj"), AllOf(StartsWith("# about?it\no some\n"), HasSubstr("# 2\n")));
  const TriangleMesh back = read_mesh(folder / "some.obj");
  ASSERT_EQ(back.vertices.size(), 4u);
  ASSERT_EQ(back.triangles.size(), 2u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(back.vertices[back.triangles[0][k]], mesh.vertices[mesh.triangles[0][k]]);
    EXPECT_EQ(back.vertices[back.triangles[1][k]], mesh.vertices[mesh.triangles[2][k]]);
  }
}

TEST(Intersect, RefusesWhatItCannotDo) {
  const Folder folder;
  const std::string at = in(folder);
  const std::pair<const char*, const char*> refusals[] = {
      {"", "one mesh is needed, or two"},
      {"crossed.obj crossed.obj crossed.obj", "one mesh is needed, or two"},
      {"- - <crossed.obj", "'-' stands twice"},
      {"none.obj", "none.obj"},
      {".", "is a directory"},
      {"--json crossed.obj", "crossed.obj is the name of a mesh, which is kept"},
      {"--first --count crossed.obj", "--first and --count exclude each other"},
      {"--count --obj o.obj crossed.obj", "--count and --obj exclude each other"},
      {"--obj o.stl crossed.obj", "--obj writes OBJ, and o.stl is the name of another format"},
      {"--obj --json crossed.obj -", "crossed.obj"}};
  for (const auto& [line, words] : refusals) {
    const Outcome o = run(at + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_EQ(o.out, "") << line;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words))) << line;
  }
  EXPECT_EQ(run("ls " + (folder / "")).out, "beside.obj\ncrossed.obj\n");
}

}  // namespace
}  // namespace plumb::tool
