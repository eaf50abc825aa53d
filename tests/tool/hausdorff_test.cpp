// Does `plumb hausdorff` bound how far two files' meshes deviate, and say where?
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <utility>

#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

std::string in(const Folder& folder) {
  std::ofstream(folder / "ground.obj") << "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n";
  std::ofstream(folder / "tent.obj")
      << "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 2 2\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
  std::ofstream(folder / "none.obj") << "v 0 0 0\n";
  return "cd " + (folder / "") + " && $PLUMB hausdorff ";
}

TEST(HausdorffCommand, SaysHowFarAndWhere) {
  const Folder folder;
  const Outcome o = run(in(folder) + "ground.obj tent.obj");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out,
              AllOf(HasSubstr("ground.obj: 4 vertices, 2 triangles, not closed\n"),
                    HasSubstr("distance at least 2, at most 2"), HasSubstr(": the farther of both ways\n"),
                    HasSubstr("of tent.obj: 2 2 2\n"), HasSubstr("nearest to it is triangle 0 of ground.obj\n")));
  EXPECT_THAT(run(in(folder) + "--from ground.obj tent.obj").out, HasSubstr(": ground.obj from tent.obj\n"));
}

// The middle of the ground is the square root of 2 from each side of the tent.
TEST(HausdorffCommand, BoundsOneWayAsAsked) {
  const Folder folder;
  const json said = json::parse(run(in(folder) + "--from --absolute 1e-9 --json - ground.obj tent.obj").out);
  EXPECT_EQ(said.at("program"), "plumb hausdorff");
  EXPECT_EQ(said.at("one_way"), true);
  EXPECT_EQ(said.at("within_tolerance"), true);
  const double least = said.at("least"), most = said.at("most");
  EXPECT_LE(least, std::sqrt(2.0));
  EXPECT_GE(most, std::sqrt(2.0));
  EXPECT_LE(most - least, 1e-9);
  EXPECT_EQ(said.at("farthest").at("mesh"), "ground.obj");
  EXPECT_EQ(said.at("nearest_to_it").at("mesh"), "tent.obj");
  const json wide = json::parse(run(in(folder) + "--from --relative 0.5 --json - ground.obj tent.obj").out);
  EXPECT_LE(wide.at("least"), std::sqrt(2.0));
  EXPECT_GE(wide.at("most"), std::sqrt(2.0));
  EXPECT_EQ(run(in(folder) + "--threads 1 ground.obj tent.obj").out,
            run(in(folder) + "--threads 2 ground.obj tent.obj").out);
}

TEST(HausdorffCommand, OfAMeshAndItselfIsZero) {
  const Folder folder;
  EXPECT_THAT(run(in(folder) + "tent.obj tent.obj").out, HasSubstr("distance 0: the farther of both ways\n"));
}

TEST(HausdorffCommand, WritesTheTrianglesAsObj) {
  const Folder folder;
  const std::string at = in(folder);
  EXPECT_EQ(run(at + "ground.obj tent.obj --obj far.obj").code, 0);
  EXPECT_THAT(content(folder / "far.obj"),
              AllOf(HasSubstr("o farthest\n"), HasSubstr("v 2 2 2\n"), HasSubstr("o nearest\n")));
  EXPECT_EQ(run(at + "ground.obj tent.obj --obj far.obj").code, 2);
}

TEST(HausdorffCommand, RefusesWhatItCannotDo) {
  const Folder folder;
  const std::string at = in(folder);
  const std::pair<const char*, const char*> refusals[] = {
      {"", "two meshes are needed"},
      {"tent.obj", "two meshes are needed"},
      {"tent.obj none.obj", "none.obj: the mesh is empty"},
      {"tent.obj absent.obj", "absent.obj"},
      {"--absolute -1 tent.obj tent.obj", "-1 is negative"},
      {"--relative nan tent.obj tent.obj", "'nan' is not a decimal"},
      {"- - <tent.obj", "'-' stands twice"}};
  for (const auto& [line, words] : refusals) {
    const Outcome o = run(at + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_EQ(o.out, "") << line;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words))) << line;
  }
}

}  // namespace
}  // namespace plumb::tool
