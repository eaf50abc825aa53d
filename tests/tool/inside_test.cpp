// Does `plumb inside` tell points in a solid from those outside and on its surface, and say where there is no solid?
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>

#include "figure/basic/solids.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/matchers.hpp"
#include "tool/rows/named_rows.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

/// A cube of side 20 about the origin that is hollow, of side 10.
std::string in(const Folder& folder) {
  TriangleMesh mesh = solids::box({-10, -10, -10}, {10, 10, 10});
  solids::append(mesh, solids::box({-5, -5, -5}, {5, 5, 5}), true);
  write_mesh(folder / "hollow.obj", mesh);
  mesh.triangles.pop_back();
  write_mesh(folder / "open.obj", mesh);
  return "cd " + (folder / "") + " && $PLUMB inside ";
}

TEST(Inside, SaysWhereEachPointIs) {
  const Folder folder;
  const Outcome o = run(in(folder) + "--point 7,0,0 --point 0,0,0 --point -10,10,10 --point 5,0,0.1 hollow.obj");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out,
            "hollow.obj: 16 vertices, 24 triangles, closed; 4 points\n"
            "point      is       winding\n"
            "7,0,0      inside         1\n"
            "0,0,0      outside        0\n"
            "-10,10,10  boundary       -\n"
            "5,0,0.1    boundary       -\n"
            "1 of 4 points are given by decimals that are no doubles; they stand for the nearest ones.\n");
}

TEST(Inside, SaysWhereTheMeshIsNoSolid) {
  const Folder folder;
  const std::string at = in(folder);
  EXPECT_THAT(run(at + "--point 7,0,0 open.obj").out,
              AllOf(HasSubstr("not closed; 1 point\n"), HasSubstr("The mesh is not closed and bounds no solid")));
  TriangleMesh mixed = solids::box({0, 0, 0}, {1, 1, 1});
  std::swap(mixed.triangles[3][0], mixed.triangles[3][1]);
  write_mesh(folder / "mixed.obj", mixed);
  const Outcome o = run(at + "--point 0.5,0.25,0.125 mixed.obj");
  EXPECT_THAT(o.out, AllOf(HasSubstr("inside "), HasSubstr("not all of it is wound alike")));
  EXPECT_THAT(run(at + "--point 7,0,0 hollow.obj").out, Not(HasSubstr("The mesh is")));
}

TEST(Inside, JsonHoldsTheSame) {
  const Folder folder;
  const json said = json::parse(run(in(folder) + "--point 7,0,0 --point 10,0,0.1 hollow.obj --json").out);
  EXPECT_EQ(said.at("program"), "plumb inside");
  EXPECT_EQ(said.at("meshes")[0].at("closed"), true);
  EXPECT_EQ(said.at("oriented"), true);
  const json& points = said.at("points");
  EXPECT_EQ(points[0].at("location"), "inside");
  EXPECT_EQ(points[0].at("winding_number"), 1);
  EXPECT_EQ(points[1].at("location"), "boundary");
  EXPECT_EQ(points[1].at("winding_number"), nullptr);
  EXPECT_EQ(points[1].at("point"), (json{10.0, 0.0, 0.1}));
  EXPECT_EQ(points[1].at("exact"), false);
}

TEST(Inside, ReadsPointsFromAFileAndStandardInput) {
  const Folder folder;
  const std::string at = in(folder), points = "# probes\n7 0 0\n\n 0, 0 ,0  # the middle\n";
  std::ofstream(folder / "probes.txt") << points;
  const Outcome of_file = run(at + "--points probes.txt hollow.obj --point 1,1,1");
  EXPECT_THAT(of_file.out, AllOf(HasSubstr("; 3 points\n"), HasSubstr("1,1,1  outside"), HasSubstr("7,0,0  inside")));
  EXPECT_THAT(run(at + "--points - hollow.obj", points).out, HasSubstr("; 2 points\n"));
  EXPECT_THAT(run(at + "--points probes.txt - <hollow.obj").out, HasSubstr("standard input: 16 vertices"));
}

TEST(NamedRows, TakesCommasAndBlanks) {
  const std::vector<NamedRow> points =
      parse_named_rows("x,y,z\n1,2,3\n4 5 6\r\n\t7 ; 8;9\n#\n  \n-1e-3,.5,+2 # x\n0.1 0 0", "list", point_shape);
  ASSERT_EQ(points.size(), 5u);
  EXPECT_EQ(point_of(points[1]), (Point3{4, 5, 6}));
  EXPECT_EQ(point_of(points[2]), (Point3{7, 8, 9}));
  EXPECT_EQ(point_of(points[3]), (Point3{-1e-3, 0.5, 2}));
  EXPECT_EQ(points[3].name, "-1e-3,.5,+2");
  EXPECT_TRUE(points[0].exact);
  EXPECT_FALSE(points[4].exact);
}

TEST(Inside, RefusesWhatItCannotRead) {
  const Folder folder;
  const std::string at = in(folder);
  std::ofstream(folder / "bad.txt") << "1,2,3\n\n1 2 3 4\n";
  std::ofstream(folder / "odd.txt") << "1 2 \033[31m3\n";
  const std::pair<const char*, const char*> refusals[] = {
      {"hollow.obj", "a --point is needed"},
      {"--point 1,2,3", "one MESH is needed"},
      {"--point 1,2 hollow.obj", "--point 1,2: this has 2 numbers; a point has three: X,Y,Z"},
      {"--point 1,2,nan hollow.obj", "'nan' is not a decimal number"},
      {"--points bad.txt hollow.obj", "bad.txt, line 3: this has 4 numbers"},
      {"--points hollow.obj hollow.obj", "hollow.obj, line 1: 'v' is not a decimal number"},
      {"--points odd.txt hollow.obj", "odd.txt, line 1: '?[31m3' is not a decimal number"},
      {"--points none.txt hollow.obj", "cannot read none.txt: No such file"},
      {"--points . hollow.obj", "cannot read .: Is a directory"},
      {"--points - -", "'-' stands twice"},
      {"--point 1,2,3 hollow.obj --json hollow.obj", "hollow.obj"},
      {"--points bad.txt hollow.obj --json bad.txt", "--json would replace bad.txt, which this run reads"}};
  for (const auto& [line, words] : refusals) {
    const Outcome o = run(at + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_EQ(o.out, "") << line;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words))) << line;
  }
}

}  // namespace
}  // namespace plumb::tool
