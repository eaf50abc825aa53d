// `plumb convert` as a user meets it: coordinates that come back bit for bit, what is told, and what is not replaced.
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

void put(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

/// A square and a triangle, with coordinates at the ends of the doubles and decimals that are none.
const char* const odd_mesh =
    "v 0.1 0 0\nv 1e-300 1 0\nv 1 1 0.3333333333333333\nv 1 5e-324 0\n"
    "v -0.30000000000000004 1.7976931348623157e308 2\nf 1 2 3 4\nf 1 2 5\nf 1 2\n";

TEST(Convert, KeepsFacesAndEveryBit) {
  const Folder folder;
  put(folder / "a.obj", odd_mesh);
  const PolygonMesh mesh = read_polygon_mesh(folder / "a.obj");
  std::string from = "a.obj";
  for (const std::string to : {"b.ply", "c.off", "d.obj", "e.ply"}) {
    const std::string encoding = to == "e.ply" ? "--encoding binary-big-endian " : "";
    const Outcome o = run("$PLUMB convert " + encoding + (folder / from) + " " + (folder / to));
    EXPECT_EQ(o.code, 0) << o.err;
    EXPECT_THAT(o.out, HasSubstr(from + " -> "));
    const PolygonMesh back = read_polygon_mesh(folder / to);
    EXPECT_TRUE(back.vertices == mesh.vertices && back.corners == mesh.corners && back.first == mesh.first) << to;
    from = to;
  }
  EXPECT_EQ(content(folder / "d.obj").substr(0, 6), "v 0.1 ");
}

TEST(Convert, SaysWhatReadingFound) {
  const Folder folder;
  put(folder / "a.obj", odd_mesh);
  const Outcome o = run("$PLUMB convert " + (folder / "a.obj") + " " + (folder / "b.ply"));
  EXPECT_THAT(o.out, AllOf(HasSubstr("OBJ, ASCII"), HasSubstr("1 face of more than three corners\n"),
                           HasSubstr("1 face of fewer than three corners left out"),
                           HasSubstr("of 15 decimals are no doubles")));
}

TEST(Convert, WritesStlAndSaysWhatItCannotHold) {
  const Folder folder;
  put(folder / "a.obj", odd_mesh);
  EXPECT_EQ(run("$PLUMB convert " + (folder / "a.obj") + " " + (folder / "a.stl")).code, 0);
  EXPECT_EQ(read_mesh(folder / "a.stl").triangles.size(), 3U);
  const Outcome o = run("$PLUMB convert --encoding binary " + (folder / "a.obj") + " " + (folder / "b.stl"));
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, HasSubstr("b.stl"));
  EXPECT_EQ(run("test -e " + (folder / "b.stl")).code, 1);
  EXPECT_EQ(run("$PLUMB convert --encoding binary " + (folder / "a.obj") + " " + (folder / "b.obj")).code, 2);
}

TEST(Convert, ReplacesNothingUnlessAsked) {
  const Folder folder;
  put(folder / "a.obj", odd_mesh);
  put(folder / "there.ply", "mine");
  const Outcome there = run("$PLUMB convert " + (folder / "a.obj") + " " + (folder / "there.ply"));
  EXPECT_EQ(there.code, 2);
  EXPECT_THAT(there.err, AllOf(HasSubstr("there.ply is there already and is kept"), HasSubstr("--overwrite")));
  EXPECT_EQ(content(folder / "there.ply"), "mine");
  for (const std::string line : {"a.obj a.obj", "--overwrite --format stl a.obj a.obj", "--overwrite - a.obj <a.obj"}) {
    const Outcome o = run("cd " + (folder / "") + " && $PLUMB convert " + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_THAT(o.err, HasSubstr("TO would replace a.obj")) << line;
    EXPECT_EQ(content(folder / "a.obj"), odd_mesh);
  }
  EXPECT_EQ(run("$PLUMB convert --overwrite " + (folder / "a.obj") + " " + (folder / "there.ply")).code, 0);
  EXPECT_EQ(read_polygon_mesh(folder / "there.ply").vertices.size(), 5U);
  // What fails replaces nothing either.
  EXPECT_EQ(run("$PLUMB convert --overwrite nope.obj " + (folder / "there.ply")).code, 2);
  EXPECT_EQ(read_polygon_mesh(folder / "there.ply").vertices.size(), 5U);
}

TEST(Convert, WritesToStandardOutputAndByFormat) {
  const Folder folder;
  put(folder / "a.obj", odd_mesh);
  const Outcome o = run("$PLUMB convert --format off " + (folder / "a.obj") + " -");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, StartsWith("OFF\n5 2 "));
  EXPECT_EQ(run("$PLUMB convert -q --format off " + (folder / "a.obj") + " -").out, o.out);
  EXPECT_EQ(run("$PLUMB convert --format off " + (folder / "a.obj") + " /dev/stdout | cat").out, o.out);
  const Outcome from_input = run("$PLUMB convert - " + (folder / "c.stl"), odd_mesh);
  EXPECT_EQ(from_input.code, 0) << from_input.err;
  EXPECT_THAT(from_input.out, HasSubstr("1 face of more than three corners, triangulated"));
  EXPECT_EQ(read_mesh(folder / "c.stl").triangles.size(), 3U);
  EXPECT_EQ(run("$PLUMB convert --format PLY " + (folder / "a.obj") + " " + (folder / "b.dat")).code, 0);
  EXPECT_THAT(content(folder / "b.dat"), StartsWith("ply\n"));
}

TEST(Convert, RefusesWhatItCannotDo) {
  const Folder folder;
  put(folder / "a.obj", odd_mesh);
  for (const auto& [arguments, words] : std::vector<std::pair<std::string, std::string>>{
           {"", "two files are needed"},
           {folder / "a.obj", "two files are needed"},
           {(folder / "a.obj") + " " + (folder / "b.xyz"), "b.xyz"},
           {(folder / "a.obj") + " " + (folder / "no/b.ply"), "b.ply"},
           {(folder / "a.obj") + " -", "does not tell the format"},
           {(folder / "missing.obj") + " -", "does not tell the format"},  // before anything is read
           {"--format dwg " + (folder / "a.obj") + " " + (folder / "b.obj"), "--format"}}) {
    const Outcome o = run("$PLUMB convert " + arguments);
    EXPECT_EQ(o.code, 2) << arguments;
    EXPECT_THAT(o.err, HasSubstr(words)) << arguments;
  }
}

}  // namespace
}  // namespace plumb::tool
