// Does `plumb distance` say how far two meshes are apart, and where?
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

constexpr auto floor_mesh = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nf 1 2 3\nf 1 3 4\n";
constexpr auto spike = "v 3 1 0.1\nv 3 0 5\nv 3 2 5\nf 1 2 3\n";

std::string in(const Folder& folder) {
  std::ofstream(folder / "floor.obj") << floor_mesh;
  std::ofstream(folder / "spike.obj") << spike;
  return "cd " + (folder / "") + " && $PLUMB distance ";
}

TEST(Distance, SaysHowFarAndBetweenWhich) {
  const Folder folder;
  const Outcome o = run(in(folder) + "floor.obj spike.obj");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out,
            "floor.obj: 4 vertices, 2 triangles, not closed\n"
            "spike.obj: 3 vertices, 1 triangles, not closed\n"
            "distance 0.1\n"
            "    triangle at      point\n"
            "a          0 face    3 1 0\n"
            "b          0 vertex  3 1 0.1\n");
}

TEST(Distance, JsonNamesTheVerticesOfFeatures) {
  const Folder folder;
  const json said = json::parse(run(in(folder) + "spike.obj floor.obj --json").out);
  EXPECT_EQ(said.at("program"), "plumb distance");
  EXPECT_EQ(said.at("distance"), 0.1);
  EXPECT_EQ(said.at("meet"), false);
  EXPECT_EQ(said.at("meshes")[1].at("mesh"), "floor.obj");
  const json &a = said.at("nearest")[0], &b = said.at("nearest")[1];
  EXPECT_EQ(a.at("feature"), "vertex");
  EXPECT_EQ(a.at("vertex_numbers"), (json{0}));
  EXPECT_EQ(b.at("feature"), "face");
  EXPECT_EQ(b.at("vertex_numbers"), (json{0, 1, 2}));
  EXPECT_EQ(b.at("point"), (json{3.0, 1.0, 0.0}));
}

TEST(Distance, IsZeroWhereTheyMeetAndOfSurfaces) {
  const Folder folder;
  EXPECT_THAT(run(in(folder) + "floor.obj floor.obj").out, HasSubstr("distance 0: they meet\n"));
  write_mesh(folder / "room.obj", solids::box({-10, -10, -10}, {10, 10, 10}));
  write_mesh(folder / "lamp.obj", solids::box({0, 0, 7}, {1, 1, 8}));
  EXPECT_THAT(run(in(folder) + "room.obj lamp.obj").out, HasSubstr("distance 2\n"));
}

// A quarter of the least double rounds to zero: the triangles are apart all the same.
TEST(Distance, ThatRoundsToZeroIsNoMeeting) {
  const Folder folder;
  std::ofstream(folder / "slope.obj") << "v 0 0 0\nv 4 0 0\nv 0 4 5e-324\nf 1 2 3\n";
  std::ofstream(folder / "point.obj") << "v 0 1 0\nv 0 1 0\nv 0 1 0\nf 1 2 3\n";
  const json said = json::parse(run(in(folder) + "slope.obj point.obj --json").out);
  EXPECT_EQ(said.at("distance"), 0.0);
  EXPECT_EQ(said.at("meet"), false);
}

TEST(Distance, WritesTheTrianglesAsObj) {
  const Folder folder;
  const std::string at = in(folder);
  EXPECT_EQ(run(at + "floor.obj spike.obj --obj near.obj").code, 0);
  EXPECT_THAT(content(folder / "near.obj"), AllOf(HasSubstr("o a\nv 0 0 0\n"), HasSubstr("o b\nv 3 1 0.1\n")));
  EXPECT_EQ(run(at + "floor.obj spike.obj --obj near.obj").code, 2);
  EXPECT_EQ(run(at + "floor.obj spike.obj --obj near.obj --overwrite").code, 0);
}

TEST(Distance, RefusesWhatItCannotDo) {
  const Folder folder;
  const std::string at = in(folder);
  const std::pair<const char*, const char*> refusals[] = {{"", "two meshes are needed"},
                                                          {"floor.obj", "two meshes are needed"},
                                                          {"floor.obj floor.obj floor.obj", "two meshes are needed"},
                                                          {"floor.obj none.obj", "none.obj"},
                                                          {"- - <floor.obj", "'-' stands twice"},
                                                          {"floor.obj spike.obj --obj no/o.obj", "no/o.obj"},
                                                          {"--json floor.obj spike.obj", "which is kept"}};
  for (const auto& [line, words] : refusals) {
    const Outcome o = run(at + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words))) << line;
  }
}

}  // namespace
}  // namespace plumb::tool
