// Does `plumb ray` say what rays at a file's mesh hit, and refuse what is no ray?
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

using testing::HasSubstr;

constexpr auto roof = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3\nf 1 3 4\n";

TEST(RayCommand, SaysFirstAndAllHits) {
  const Folder folder;
  std::ofstream(folder / "roof.obj") << roof;
  const std::string at = "cd " + (folder / "") + " && $PLUMB ray ";
  const Outcome first = run(at + "--ray 1,1,3,0,0,-1 --ray 1.5,0.5,3,0,0,1 roof.obj");
  EXPECT_EQ(first.code, 0) << first.err;
  EXPECT_THAT(first.out, HasSubstr("4 vertices, 2 triangles, not closed; 2 rays\n"));
  EXPECT_THAT(first.out, HasSubstr("1,1,3,0,0,-1         2          0              3 edge    1 1 0\n"));
  EXPECT_THAT(first.out, HasSubstr("1.5,0.5,3,0,0,1      0\n"));
  const auto report =
      nlohmann::json::parse(run(at + "--segment 1,1,3,1,1,-3 --ray 0.1,0,1,0,0,-1 roof.obj --json -").out);
  const auto& rays = report.at("rays");
  EXPECT_EQ(rays.at(0).at("kind"), "ray");
  EXPECT_EQ(rays.at(0).at("exact"), false);
  EXPECT_EQ(rays.at(1).at("kind"), "segment");
  ASSERT_EQ(rays.at(1).at("hits").size(), 2u);
  EXPECT_EQ(rays.at(1).at("hits").at(1).at("triangle"), 1);
  EXPECT_EQ(rays.at(1).at("hits").at(1).at("t"), 0.5);
}

TEST(RayCommand, ReadsTablesOfRaysAndSegments) {
  const Folder folder;
  std::ofstream(folder / "roof.obj") << roof;
  std::ofstream(folder / "rays.csv") << "ox,oy,oz,dx,dy,dz\n1.5,0.5,3,0,0,-1\n# past it\n9 9 9 0 0 -1\n";
  std::ofstream(folder / "ways.txt") << "0.5 1.5 1  0.5 1.5 0\n";
  const std::string at = "cd " + (folder / "") + " && $PLUMB ray ";
  const auto report =
      nlohmann::json::parse(run(at + "--rays rays.csv --segments ways.txt --ray 1,1,3,0,0,1 roof.obj --json -").out);
  const auto& rays = report.at("rays");
  ASSERT_EQ(rays.size(), 4u);
  EXPECT_EQ(rays.at(0).at("name"), "1,1,3,0,0,1");
  EXPECT_EQ(rays.at(1).at("name"), "1.5,0.5,3,0,0,-1");
  EXPECT_EQ(rays.at(1).at("hits").at(0).at("triangle"), 0);
  EXPECT_TRUE(rays.at(2).at("hits").empty());
  EXPECT_EQ(rays.at(3).at("kind"), "segment");
  EXPECT_EQ(rays.at(3).at("hits").at(0).at("triangle"), 1);
  EXPECT_THAT(run(at + "--rays - roof.obj", "1.5,0.5,3,0,0,-1\n").out, HasSubstr("; 1 ray\n"));
}

TEST(RayCommand, WritesTheTrianglesThatAreSaidToBeHit) {
  const Folder folder;
  std::ofstream(folder / "roof.obj") << roof;
  const std::string at = "cd " + (folder / "") + " && $PLUMB ray --ray 1,1,3,0,0,-1 roof.obj ";
  EXPECT_EQ(run(at + "--obj first.obj").code, 0);
  EXPECT_EQ(content(folder / "first.obj"),
            "# plumb ray: the triangles of roof.obj that are hit\no hit\nv 0 0 0\nv 2 0 0\nv 2 2 0\n# 0\nf 1 2 3\n");
  EXPECT_EQ(run(at + "--obj first.obj --all").code, 2);
  EXPECT_EQ(run(at + "--obj first.obj --all --overwrite").code, 0);
  EXPECT_THAT(content(folder / "first.obj"), HasSubstr("v 0 2 0\n# 0\nf 1 2 3\n# 1\nf 1 3 4\n"));
}

TEST(RayCommand, RefusesWhatIsNoRay) {
  const Folder folder;
  std::ofstream(folder / "roof.obj") << roof;
  std::ofstream(folder / "still.csv") << "1,2,3,0,0,-1\n4 5 6 0 0 0\n";
  std::ofstream(folder / "segments.csv") << "ax,ay,az,bx,by,bz\n1,2,3,1,2,-3\n";
  std::ofstream(folder / "ends.csv") << "Start X;Start Y;Start Z;End X;End Y;End Z\n1;2;3;1;2;-3\n";
  std::ofstream(folder / "rays.csv") << "ox,oy,oz,dx,dy,dz\n1,2,3,0,0,-1\n";
  std::ofstream(folder / "bad.csv") << "1,2,3,0,0,-1\n1,2,3,0,0\n";
  const std::string at = "cd " + (folder / "") + " && $PLUMB ray ";
  const std::pair<const char*, const char*> refusals[] = {
      {"roof.obj", "a --ray or a --segment is needed"},
      {"--ray 1,2,3 roof.obj", "this has 3 numbers; a ray has six: origin and direction"},
      {"--segment 1,2,3,4,5,x roof.obj", "--segment 1,2,3,4,5,x"},
      {"--ray 1,2,3,0,0,-0 roof.obj", "--ray: the direction of 1,2,3,0,0,-0 is zero"},
      {"--rays still.csv roof.obj", "still.csv: the direction of 4,5,6,0,0,0 is zero"},
      {"--rays bad.csv roof.obj", "bad.csv, line 2: this has 5 numbers; a ray has six"},
      {"--rays segments.csv roof.obj",
       "segments.csv: the columns are named 'ax,ay,az,bx,by,bz', and are not read as "
       "'ox,oy,oz,dx,dy,dz'; --segments takes them"},
      {"--rays ends.csv roof.obj", "--segments takes them"},
      {"--segments rays.csv roof.obj",
       "rays.csv: the columns are named 'ox,oy,oz,dx,dy,dz', and are not read as "
       "'ax,ay,az,bx,by,bz'; --rays takes them"},
      {"--segments roof.obj roof.obj", "roof.obj"},
      {"--rays - -", "'-' stands twice"},
      {"--rays bad.csv roof.obj --json bad.csv", "--json would replace bad.csv, which this run reads"},
      {"--ray 1,2,3,4,5,6", "one MESH is needed"},
      {"--ray 1,2,3,4,5,6 none.obj", "none.obj"}};
  for (const auto& [line, words] : refusals) {
    const Outcome o = run(at + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_THAT(o.err, HasSubstr(words)) << line;
  }
}

}  // namespace
}  // namespace plumb::tool
