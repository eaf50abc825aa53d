// `plumb boolean` as a user meets it: solids of files that are combined, what is told, what is refused, and what is not
// replaced.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "figure/basic/solids.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "plumb/surface/topology/faults.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

std::string in(const Folder& folder) { return "cd " + (folder / "") + " && $PLUMB boolean "; }

/// Cubes of side 2: `a`, `b` moved by 1 along all axes, `beside` face to face with `a`, `far`.
std::string with_cubes(const Folder& folder) {
  write_mesh(folder / "a.obj", solids::box({0, 0, 0}, {2, 2, 2}));
  write_mesh(folder / "b.obj", solids::box({1, 1, 1}, {3, 3, 3}));
  write_mesh(folder / "beside.obj", solids::box({2, 0, 0}, {4, 2, 2}));
  write_mesh(folder / "far.stl", solids::box({9, 0, 0}, {11, 2, 2}));
  return in(folder);
}

void expect_volume(const Folder& folder, const std::string& line, double expected) {
  const std::string at = with_cubes(folder);
  const Outcome o = run(at + line + " -o out.obj --overwrite --json out.json");
  ASSERT_EQ(o.code, 0) << line << ": " << o.err;
  const TriangleMesh made = read_mesh(folder / "out.obj");
  EXPECT_EQ(volume(made), expected) << line;
  // Where two pieces of a symmetric difference touch, an edge has four triangles.
  EXPECT_EQ(find_faults(made).any(), line.starts_with("symmetric")) << line;
  const json said = json::parse(content(folder / "out.json"));
  EXPECT_EQ(said.at("volume"), expected) << line;
  EXPECT_EQ(said.at("triangles"), made.triangles.size()) << line;
  EXPECT_EQ(said.at("is_sound"), true) << line;
  EXPECT_EQ(said.at("written"), "out.obj") << line;
}

TEST(BooleanCommand, CombinesCubes) {
  const Folder folder;
  expect_volume(folder, "union a.obj b.obj", 15);
  expect_volume(folder, "intersection a.obj b.obj", 1);
  expect_volume(folder, "difference a.obj b.obj", 7);
  expect_volume(folder, "symmetric a.obj b.obj", 14);
  expect_volume(folder, "union a.obj a.obj", 8);
  expect_volume(folder, "union a.obj b.obj beside.obj far.stl", 30);
  expect_volume(folder, "difference a.obj b.obj beside.obj", 7);
}

TEST(BooleanCommand, FaceToFaceNoWallIsLeft) {
  const Folder folder;
  expect_volume(folder, "union a.obj beside.obj", 16);
  const Outcome o = run(with_cubes(folder) + "intersection a.obj beside.obj -o none.obj");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, HasSubstr("intersection: 0 vertices, 0 triangles, empty\nsound: no point moved\n"));
  EXPECT_EQ(content(folder / "none.obj"), "");
}

TEST(BooleanCommand, SaysWhatItMade) {
  const Folder folder;
  const Outcome o = run(with_cubes(folder) + "union a.obj b.obj -o ab.ply");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out,
            "a.obj: 8 vertices, 12 triangles, closed\n"
            "b.obj: 8 vertices, 12 triangles, closed\n"
            "union: 20 vertices, 36 triangles, volume 15\n"
            "sound: no point moved\n"
            "written: ab.ply\n");
  EXPECT_EQ(o.err, "");
  const Outcome piped = run("cd " + (folder / "") + " && $PLUMB boolean difference - b.obj -o - < a.obj");
  EXPECT_EQ(piped.code, 0) << piped.err;
  EXPECT_EQ(volume(parse_mesh(piped.out, "out.obj")), 7);
}

TEST(BooleanCommand, MergesPiecesOfOnePlane) {
  const Folder folder;
  const Outcome o = run(with_cubes(folder) + "union a.obj beside.obj --merge -o merged.obj");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, HasSubstr("union: 8 vertices, 12 triangles, volume 16\nsound: no point moved\n"));
}

TEST(BooleanCommand, TakesFolders) {
  const Folder folder;
  ASSERT_EQ(run("mkdir -p " + (folder / "in/deep")).code, 0);
  write_mesh(folder / "in/a.obj", solids::box({0, 0, 0}, {2, 2, 2}));
  write_mesh(folder / "in/deep/b.off", solids::box({1, 1, 1}, {3, 3, 3}));
  const json said = json::parse(run(in(folder) + "union in -o out.stl --json -").out);
  EXPECT_EQ(said.at("volume"), 15.0);
  EXPECT_EQ(said.at("meshes").size(), 2U);
  EXPECT_EQ(volume(read_mesh(folder / "out.stl")), 15);
}

TEST(BooleanCommand, RefusesMeshesThatBoundNothingByTheirNames) {
  const Folder folder;
  const std::string at = with_cubes(folder);
  TriangleMesh open = solids::box({0, 0, 0}, {1, 1, 1}), against = open;
  open.triangles.pop_back();
  std::swap(against.triangles[3][0], against.triangles[3][1]);
  write_mesh(folder / "open.obj", open);
  write_mesh(folder / "against.obj", against);
  const Outcome o = run(at + "union a.obj open.obj against.obj -o out.obj --json out.json");
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, AllOf(HasSubstr("plumb: open.obj: the mesh is open at the edge from ("),
                           HasSubstr("run 'plumb repair open.obj -o MENDED' first\n"),
                           HasSubstr("plumb: against.obj: triangles run against each other along the edge from ("),
                           Not(HasSubstr("a.obj: the"))));
  EXPECT_EQ(run("ls " + (folder / "out.obj") + " " + (folder / "out.json")).out, "");
  const std::string twice = run(at + "union open.obj open.obj -o out.obj").err;
  EXPECT_EQ(std::count(twice.begin(), twice.end(), '\n'), 1) << twice;
  ASSERT_EQ(run("cd " + (folder / "") + " && $PLUMB repair open.obj -o mended.obj").code, 0);
  expect_volume(folder, "union mended.obj a.obj", 8);
}

TEST(BooleanCommand, InsideOutIsTold) {
  const Folder folder;
  const std::string at = with_cubes(folder);
  TriangleMesh turned = solids::box({1, 1, 1}, {3, 3, 3});
  for (auto& t : turned.triangles) std::swap(t[0], t[1]);
  write_mesh(folder / "turned.obj", turned);
  const Outcome o = run(at + "union a.obj turned.obj -o out.obj");
  EXPECT_EQ(o.code, 0);
  EXPECT_THAT(o.err, HasSubstr("turned.obj: it is wound inside out"));
  EXPECT_THAT(o.out, HasSubstr("volume 8\n"));
  EXPECT_THAT(run(at + "union --rule nonzero a.obj turned.obj -o b.ply").out, HasSubstr("volume 15\n"));
  EXPECT_THAT(run(at + "intersection --rule odd a.obj turned.obj -o c.ply").out, HasSubstr("volume 1\n"));
}

TEST(BooleanCommand, ReplacesNothingUnasked) {
  const Folder folder;
  const std::string at = with_cubes(folder), line = at + "union a.obj b.obj -o ";
  const std::string before = content(folder / "far.stl"), a = content(folder / "a.obj");
  const Outcome o = run(line + "far.stl");
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, HasSubstr("far.stl is there already"));
  EXPECT_EQ(content(folder / "far.stl"), before);
  EXPECT_EQ(run(line + "far.stl --overwrite").code, 0);
  EXPECT_NE(content(folder / "far.stl"), before);
  EXPECT_EQ(run(line + "a.obj --overwrite").code, 2) << "it is read";
  EXPECT_EQ(content(folder / "a.obj"), a);
}

TEST(BooleanCommand, WhatIsNotSoundIsWrittenOnlyWhereAsked) {
  const Folder folder;
  const TriangleMesh one = solids::turned(solids::torus(3, 1, 16, 8));
  TriangleMesh other = one;
  for (Point3& p : other.vertices) p.x = std::nextafter(p.x, 10);
  write_mesh(folder / "one.obj", one);
  write_mesh(folder / "other.obj", other);
  const std::string line = in(folder) + "union one.obj other.obj -o out.obj --json out.json ";
  const Outcome o = run(line + "--rounds 1");
  EXPECT_EQ(o.code, 1) << o.err;
  EXPECT_THAT(o.out, AllOf(HasSubstr("not sound: no point moved farther than"), HasSubstr(" cross or touch\n"),
                           Not(HasSubstr("written"))));
  EXPECT_THAT(o.err, HasSubstr("is not written; allow more '--rounds'"));
  EXPECT_EQ(run("ls " + (folder / "out.obj")).out, "");
  json said = json::parse(content(folder / "out.json"));
  EXPECT_EQ(said.at("is_sound"), false);
  EXPECT_TRUE(said.at("written").is_null());
  EXPECT_GT(said.at("meeting_triangles").size(), 0U);
  EXPECT_EQ(run(line + "--rounds 1 --unsound").code, 1);
  EXPECT_EQ(read_mesh(folder / "out.obj").triangles.size(), said.at("triangles"));
  EXPECT_EQ(run(line + "--overwrite").code, 0);
  EXPECT_FALSE(find_faults(read_mesh(folder / "out.obj")).any());
  said = json::parse(content(folder / "out.json"));
  EXPECT_GT(said.at("rounds"), 1);
  EXPECT_LT(said.at("moved"), 1e-13);
  EXPECT_EQ(said.at("meeting_triangles"), json::array());
}

TEST(BooleanCommand, SaysWhatItNeeds) {
  const Folder folder;
  const std::string at = with_cubes(folder);
  const std::pair<const char*, const char*> refusals[] = {
      {"", "an operation and two meshes are needed"},
      {"union", "add '-o FILE'"},
      {"union a.obj b.obj", "add '-o FILE'"},
      {"union a.obj -o x.obj", "two meshes are needed"},
      {"merge a.obj b.obj -o x.obj", "merge not in"},
      {"union a.obj none.obj -o x.obj", "none.obj"},
      {"union a.obj b.obj -o x.doc", "x.doc: the name does not tell the format"},
      {"union - - -o x.obj", "'-' stands twice"},
      {"union a.obj b.obj -o x.obj --rounds 0", "--rounds"},
      {"union a.obj b.obj -o x.obj --rule even", "even not in"}};
  for (const auto& [line, words] : refusals) {
    const Outcome o = run(at + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_EQ(o.out, "") << line;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words))) << line;
  }
  EXPECT_EQ(run("ls " + (folder / "x.obj")).out, "");
}

}  // namespace
}  // namespace plumb::tool
