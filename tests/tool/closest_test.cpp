// Does `plumb closest` say how far points are from a file's mesh, and where it is nearest to them?
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>

#include "figure/basic/solids.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

std::string in(const Folder& folder) {
  write_mesh(folder / "cube.obj", solids::box({0, 0, 0}, {2, 2, 2}));
  std::ofstream(folder / "none.obj") << "v 0 0 0\n";
  std::ofstream(folder / "points.csv") << "x,y,z\n1,0.5,5\n3,3,2\n# far\n1 1 -9\n";
  return "cd " + (folder / "") + " && $PLUMB closest ";
}

TEST(ClosestCommand, SaysHowFarAndWhere) {
  const Folder folder;
  const Outcome o = run(in(folder) + "cube.obj points.csv --point 0.1,-3,-4");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out,
              AllOf(HasSubstr("cube.obj: 8 vertices, 12 triangles, closed; 4 points\n"),
                    HasSubstr("0.1,-3,-4                       5 "), HasSubstr("1,0.5,5                         3 "),
                    HasSubstr("1 of 4 points are given by decimals that are no doubles")));
  EXPECT_THAT(o.out, HasSubstr(" edge    0.1 0 0\n"));
  EXPECT_THAT(o.out, HasSubstr(" vertex  2 2 2\n"));
}

TEST(ClosestCommand, JsonHoldsTheSame) {
  const Folder folder;
  const json said = json::parse(run(in(folder) + "cube.obj points.csv --json").out);
  EXPECT_EQ(said.at("program"), "plumb closest");
  EXPECT_EQ(said.at("within"), nullptr);
  const json& closest = said.at("closest");
  ASSERT_EQ(closest.size(), 3u);
  EXPECT_EQ(closest[0].at("name"), "1,0.5,5");
  EXPECT_EQ(closest[0].at("distance"), 3.0);
  EXPECT_EQ(closest[0].at("feature"), "face");
  EXPECT_EQ(closest[0].at("point"), (json{1.0, 0.5, 2.0}));
  EXPECT_EQ(closest[1].at("distance"), std::sqrt(2.0));
  EXPECT_EQ(closest[1].at("vertex_numbers").size(), 1u);
  EXPECT_EQ(closest[2].at("asked_at"), (json{1.0, 1.0, -9.0}));
}

TEST(ClosestCommand, ARadiusIsClosed) {
  const Folder folder;
  const Outcome o = run(in(folder) + "--within 3 cube.obj points.csv");
  EXPECT_THAT(o.out,
              AllOf(HasSubstr("1,0.5,5                       3 "), HasSubstr("1,1,-9                        -\n"),
                    HasSubstr("1 of 3 points are farther from the mesh than 3.\n")));
  const json said = json::parse(run(in(folder) + "--within 2.9999999999999996 cube.obj points.csv --json").out);
  EXPECT_EQ(said.at("closest")[0].at("distance"), nullptr);
  EXPECT_FALSE(said.at("closest")[0].contains("triangle"));
}

TEST(ClosestCommand, ListsTenUnlessAllAreAskedFor) {
  const Folder folder;
  const std::string at = in(folder);
  std::ofstream many(folder / "many.csv");
  for (int i = 0; i < 200; ++i) many << i << ",1,1\n";
  many.close();
  EXPECT_THAT(run(at + "cube.obj many.csv").out,
              AllOf(HasSubstr("and 190 more; --all lists them\n"), Not(HasSubstr("199,1,1"))));
  EXPECT_THAT(run(at + "--all cube.obj many.csv").out, AllOf(Not(HasSubstr("more;")), HasSubstr("199,1,1")));
  EXPECT_EQ(run(at + "--all --threads 1 cube.obj many.csv").out, run(at + "--all --threads 2 cube.obj many.csv").out);
}

TEST(ClosestCommand, WritesTheTrianglesAsObj) {
  const Folder folder;
  const std::string at = in(folder);
  EXPECT_EQ(run(at + "cube.obj points.csv --obj near.obj").code, 0);
  EXPECT_THAT(content(folder / "near.obj"), HasSubstr("o nearest\nv "));
  EXPECT_EQ(run(at + "cube.obj points.csv --obj near.obj").code, 2);
  EXPECT_EQ(run(at + "cube.obj points.csv --obj near.obj --overwrite").code, 0);
}

TEST(ClosestCommand, RefusesWhatItCannotDo) {
  const Folder folder;
  const std::string at = in(folder);
  std::ofstream(folder / "flat.csv") << "1,2\n";
  const std::pair<const char*, const char*> refusals[] = {
      {"", "one MESH is needed"},
      {"cube.obj", "points are needed"},
      {"none.obj points.csv", "none.obj: the mesh is empty"},
      {"cube.obj points.csv points.csv", "at most one file of points"},
      {"cube.obj flat.csv", "flat.csv, line 1: this has 2 numbers; a point has three: X,Y,Z"},
      {"cube.obj absent.csv", "cannot read absent.csv"},
      {"cube.obj --point 1,2,nan", "'nan' is not a decimal number"},
      {"cube.obj points.csv --within -1", "-1 is negative"},
      {"cube.obj points.csv --within much", "'much' is not a decimal number"},
      {"- - <cube.obj", "'-' stands twice"},
      {"cube.obj points.csv --json points.csv", "points.csv"}};
  for (const auto& [line, words] : refusals) {
    const Outcome o = run(at + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_EQ(o.out, "") << line;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words))) << line;
  }
}

}  // namespace
}  // namespace plumb::tool
