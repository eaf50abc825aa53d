// `plumb csg`, `plumb resolve` and `plumb split` as a user meets them: what OpenSCAD exports, what crosses itself, what a
// plane or a mesh parts, what is refused.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "figure/basic/solids.hpp"
#include "plumb/figure/measures/measures.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

std::string at(const Folder& folder) { return "cd " + (folder / "") + " && $PLUMB "; }

/// What the text makes, where it makes something sound.
double volume_of_text(const Folder& folder, const std::string& text) {
  std::ofstream(folder / "in.csg") << text;
  const Outcome o = run(at(folder) + "csg in.csg -o out.obj --overwrite --json out.json");
  EXPECT_EQ(o.code, 0) << text << ": " << o.err;
  if (o.code != 0) return -1;
  const json said = json::parse(content(folder / "out.json"));
  EXPECT_EQ(said.at("is_sound"), true) << text;
  const double told = said.at("volume");
  if (told != 0) EXPECT_EQ(volume(read_mesh(folder / "out.obj")), told) << text;
  return told;
}

TEST(CsgCommand, MakesWhatTextsSay) {
  const Folder folder;
  write_mesh(folder / "box.stl", solids::box({0, 0, 0}, {2, 2, 2}));
  const std::vector<std::pair<std::string, double>> texts{
      {"cube(2);", 8},
      {"cube(size = [1, 2, 3], center = true);", 6},
      {"group() { cube(1); group() { cube([2, 1, 1], center = false); } group(); }", 2},
      {"difference() { cube(4); translate([1, 1, 1]) cube(4); translate([0, 0, -1]) cube([1, 1, 9]); }", 33},
      {"difference() { group(); cube(1); }", 0},
      {"intersection() { cube(4); translate([1, 1, 1]) cube(4); }", 27},
      {"intersection() { cube(4); group(); }", 0},
      {"symmetric_difference() { cube(2); translate([1, 0, 0]) cube(2); translate([1, 0, 0]) cube(2); }", 8},
      {"multmatrix([[0, -1, 0, 5], [1, 0, 0, 0], [0, 0, 2, 0], [0, 0, 0, 1]]) cube(1);", 2},
      {"multmatrix([[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) { cube(1); }", 1},
      {"multmatrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0], [0, 0, 0, 1]]) { cube(1); }", 0},
      {"scale([2, 2, 2]) { translate([0.5, 0, 0]) cube(1); cube(1); }", 12},
      {"polyhedron(points = [[0,0,0],[6,0,0],[0,1,0],[0,0,1]], faces = [[0,1,2],[0,3,1],[1,3,2],[0,2,3]]);", 1},
      {"cylinder($fn = 4, $fa = 12, $fs = 2, h = 3, r1 = 1, r2 = 1, center = true);", 6},
      {"cylinder($fn = 4, h = 3, r1 = 1, r2 = 0);", 2},
      {"color([1, 0, 0, 1]) render(convexity = 2) import(file = \"box.stl\", layer = \"\", origin = [0, 0]);", 8},
      {"hull() { cube(1); translate([3, 0, 0]) group() { cube(1); } }", 4},
      {"hull() { cube(size = [1, 1, 1]); }\n// nothing\n/* nor\n here */ %cube(9); *cube(8); #cube(1);", 1}};
  for (const auto& [text, expected] : texts) EXPECT_EQ(volume_of_text(folder, text), expected) << text;
}

TEST(CsgCommand, FacetsAreThoseOfOpenScad) {
  const Folder folder;
  for (const auto& [text, vertices, triangles] :
       {std::tuple{"cylinder(h = 1, r = 10);", 60, 116},  // 30 around, by $fa
        std::tuple{"cylinder(h = 1, r = 1);", 10, 16},    // 5 around, the fewest
        std::tuple{"cylinder(h = 1, r = 10, $fn = 100);", 200, 396},
        std::tuple{"cylinder(h = 1, r1 = 10, r2 = 0, $fn = 7);", 8, 12},
        std::tuple{"sphere(r = 10);", 450, 896},  // 15 rings of 30
        std::tuple{"sphere(r = 1, $fn = 8);", 32, 60}}) {
    volume_of_text(folder, text);
    const json said = json::parse(content(folder / "out.json"));
    EXPECT_EQ(said.at("vertices"), vertices) << text;
    EXPECT_EQ(said.at("triangles"), triangles) << text;
  }
}

TEST(CsgCommand, CountsWhatMatricesRound) {
  const Folder folder;
  volume_of_text(folder,
                 "multmatrix([[1, 0, 0, 0.1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) scale([3, 1, 1]) cube(0.7);");
  const json said = json::parse(content(folder / "out.json"));
  EXPECT_EQ(said.at("placed_coordinates"), 24);
  EXPECT_EQ(said.at("rounded_coordinates"), 4);
  volume_of_text(folder, "translate([1, 2, 3]) cube(1);");
  EXPECT_EQ(json::parse(content(folder / "out.json")).at("rounded_coordinates"), 0);
}

TEST(CsgCommand, SaysWhatItMade) {
  const Folder folder;
  const Outcome o = run("cd " + (folder / "") +
                        " && echo 'difference() { cube(4); translate([1,1,1]) cube(4); }' | $PLUMB csg - -o out.obj");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out,
            "standard input: 2 solids\n"
            "csg: 14 vertices, 24 triangles, volume 37\n"
            "sound: no point moved\n"
            "written: out.obj\n");
}

TEST(CsgCommand, RefusesByLineAndName) {
  const Folder folder;
  TriangleMesh open = solids::box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  write_mesh(folder / "open.obj", open);
  const std::vector<std::pair<std::string, std::string>> texts{
      {"cube(1);\nlinear_extrude(height = 2) { square(1); }", "in.csg:2: linear_extrude: what is extruded is not read"},
      {"minkowski() { cube(1); cube(1); }", "in.csg:1: minkowski: sums of solids are not made"},
      {"cube(1;", "in.csg:1: ';' stands where ',' is expected"},
      {"\n\ngroup() { cube(1);", "in.csg:3: the text ends where '}' is expected"},
      {"cube(size = [1, 2]);", "in.csg:1: cube: size is not three numbers"},
      {"cube(-1);", "in.csg:1: cube: size is not greater than 0"},
      {"cube(nan);", "in.csg:1: 'nan' stands where a finite number"},
      {"cube(1e999);", "in.csg:1: '1e999' stands where a finite number"},
      {"sphere(r = 1, $fn = 1e9);", "in.csg:1: sphere: it would have 1000000000 fragments; at most 4096 are made"},
      {"x = 3;", "in.csg:1: '=' stands where '(' is expected"},
      {"frobnicate();", "in.csg:1: frobnicate: is no solid or operation that is known"},
      {"hull() { difference() { cube(2); cube(1); } }",
       "in.csg:1: difference: in a hull, solids are united and placed"},
      {"multmatrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 2]]) cube(1);", "the last row of the matrix"},
      {"multmatrix([[1e308, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]) cube(9);", "beyond all doubles under its matrices"},
      {"polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], faces = [[0,1,2],[0,3,1]]);",
       "in.csg:1: polyhedron: the mesh is open at the edge from ("},
      {"polyhedron(points = [[0,0,0],[1,0,0],[0,1,0]], faces = [[0,1,7]]);", "a face names no point: 7"},
      {"import(\"open.obj\");", "in.csg:1: import: the mesh is open at the edge from ("},
      {"import(\"open.obj\");", "; run 'plumb repair open.obj -o MENDED' first"},
      {"import(\"absent.obj\");", "absent.obj"},
      {std::string(500, '[') + "1", "in.csg:1: '[' stands where the name"},
      {"cube(" + std::string(500, '[') + "1", "in.csg:1: brackets are nested deeper than 400"}};
  for (const auto& [text, expected] : texts) {
    std::ofstream(folder / "in.csg") << text;
    const Outcome o = run(at(folder) + "csg in.csg -o out.obj --json out.json");
    EXPECT_EQ(o.code, 2) << text;
    EXPECT_THAT(o.err, HasSubstr(expected)) << text;
    EXPECT_EQ(run("ls " + (folder / "out.obj") + " " + (folder / "out.json")).out, "") << text;
  }
  EXPECT_EQ(run(at(folder) + "csg in.csg").code, 2);
  EXPECT_EQ(run(at(folder) + "csg in.csg -o in.csg").code, 2);
}

TEST(ResolveCommand, MakesOneOfWhatCrossesItself) {
  const Folder folder;
  TriangleMesh twice = solids::box({0, 0, 0}, {2, 2, 2});
  const TriangleMesh other = solids::box({1, 1, 1}, {3, 3, 3});
  for (auto t : other.triangles) twice.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  twice.vertices.insert(twice.vertices.end(), other.vertices.begin(), other.vertices.end());
  write_mesh(folder / "twice.obj", twice);
  EXPECT_EQ(run(at(folder) + "resolve twice.obj -o one.obj").out,
            "twice.obj: 16 vertices, 24 triangles, closed\n"
            "resolve: 20 vertices, 36 triangles, volume 15\n"
            "sound: no point moved\n"
            "written: one.obj\n");
  EXPECT_EQ(volume(read_mesh(folder / "one.obj")), 15);
  EXPECT_EQ(run(at(folder) + "resolve twice.obj --rule odd -o odd.obj").code, 0);
  EXPECT_EQ(volume(read_mesh(folder / "odd.obj")), 14);
  EXPECT_THAT(run(at(folder) + "resolve twice.obj odd.obj -o no.obj").err, HasSubstr("resolve: takes one mesh"));
  twice.triangles.pop_back();
  write_mesh(folder / "open.obj", twice);
  const Outcome o = run(at(folder) + "resolve open.obj -o no.obj");
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, HasSubstr("open.obj: the mesh is open at the edge from ("));
}

TEST(SplitCommand, CutsByPlanesAndMeshes) {
  const Folder folder;
  write_mesh(folder / "a.obj", solids::box({0, 0, 0}, {2, 2, 2}));
  write_mesh(folder / "b.obj", solids::box({1, 1, 1}, {3, 3, 3}));
  EXPECT_EQ(run(at(folder) + "split a.obj --plane z=0.5 -o up.obj --other down.obj").out,
            "a.obj: 8 vertices, 12 triangles, closed\n"
            "above: 12 vertices, 20 triangles, volume 6\n"
            "sound: no point moved\n"
            "written: up.obj\n"
            "below: 12 vertices, 20 triangles, volume 2\n"
            "sound: no point moved\n"
            "written: down.obj\n");
  EXPECT_EQ(volume(read_mesh(folder / "up.obj")), 6);
  EXPECT_EQ(volume(read_mesh(folder / "down.obj")), 2);
  const auto volumes = [&](const std::string& line) {
    const Outcome o =
        run(at(folder) + "split a.obj " + line + " -o up.obj --other down.obj --overwrite --json out.json");
    EXPECT_EQ(o.code, 0) << o.err;
    const json said = json::parse(content(folder / "out.json"));
    return std::pair<double, double>(said.at("split_parts").at(0).at("volume"),
                                     said.at("split_parts").at(1).at("volume"));
  };
  EXPECT_EQ(volumes("--by b.obj"), std::pair(7.0, 1.0));
  EXPECT_EQ(volumes("--by b.obj --merge"), std::pair(7.0, 1.0));
  EXPECT_EQ(volumes("--plane 1,1,0,2"), std::pair(4.0, 4.0));
  EXPECT_EQ(volumes("--plane 0,0,-1,-0.5"), std::pair(2.0, 6.0));
  EXPECT_EQ(volumes("--plane 0,0,1,1,0,1,0,1,1"), std::pair(4.0, 4.0));
  EXPECT_EQ(volumes("--plane z=2"), std::pair(0.0, 8.0));
}

TEST(SplitCommand, RefusesWhatItCannotCut) {
  const Folder folder;
  TriangleMesh open = solids::box({0, 0, 0}, {1, 1, 1});
  write_mesh(folder / "a.obj", open);
  open.triangles.pop_back();
  write_mesh(folder / "open.obj", open);
  for (const auto& [words, expected] : std::vector<std::pair<std::string, std::string>>{
           {"a.obj -o o.obj", "by what is not said, or twice"},
           {"a.obj --plane z=0.5 --by a.obj -o o.obj", "by what is not said, or twice"},
           {"a.obj --plane z=0.5", "add '-o FILE'"},
           {"a.obj --plane z=0:1:0.25 -o o.obj", "is 5 planes; one is taken at a time"},
           {"a.obj --plane 0,0,0,1 -o o.obj", "has no normal"},
           {"open.obj --plane z=0.5 -o o.obj", "open.obj: the mesh is open at the edge from ("},
           {"a.obj --by open.obj -o o.obj", "run 'plumb repair open.obj -o MENDED' first"},
           {"a.obj --plane z=0.5 -o a.obj", "a.obj"}}) {
    const Outcome o = run(at(folder) + "split " + words);
    EXPECT_EQ(o.code, 2) << words;
    EXPECT_THAT(o.err, HasSubstr(expected)) << words;
    EXPECT_EQ(run("ls " + (folder / "o.obj")).out, "") << words;
  }
}

}  // namespace
}  // namespace plumb::tool
