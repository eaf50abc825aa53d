// `plumb section` as a user meets it: planes in words, the table, drawings that
// others read, and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "figure/basic/solids.hpp"
#include "plumb/arith/rational.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"
#include "tool/section/view.hpp"
#include "tool/svg_lines.hpp"
#include "tool/terminal/decimal_range.hpp"

namespace plumb::tool {
namespace {

/// A cube of side 20 about the origin that is hollow, of side 10.
std::string hollow_cube(const Folder& folder) {
  TriangleMesh mesh = solids::box({-10, -10, -10}, {10, 10, 10});
  solids::append(mesh, solids::box({-5, -5, -5}, {5, 5, 5}), true);
  write_mesh(folder / "cube.obj", mesh);
  return folder / "cube.obj";
}

json section_of(const std::string& arguments) {
  const Outcome o = run("$PLUMB section --json - " + arguments);
  EXPECT_EQ(o.code, 0) << o.err;
  return json::parse(o.out);
}

TEST(DecimalRange, AddsDecimalsAndNotDoubles) {
  const auto tenths = decimal_range("0", "1", "0.1", "x", 100);
  ASSERT_EQ(tenths.size(),
            11U);  // the sum of ten doubles nearest to 0.1 is not 1
  EXPECT_EQ(tenths[3].text, "0.3");
  EXPECT_EQ(tenths[3].value, 0.3);
  EXPECT_FALSE(tenths[3].exact);
  EXPECT_TRUE(tenths[5].exact);
  EXPECT_EQ(tenths[10].value, 1.0);
  EXPECT_EQ(tenths[10].text, "1");
  const auto wide = decimal_range("-1e2", "+1.5E+2", "25e0", "x", 100);
  ASSERT_EQ(wide.size(), 11U);
  EXPECT_EQ(wide[0].text, "-100");
  EXPECT_EQ(wide[10].text, "150");
  EXPECT_EQ(decimal_range("5", "5", ".5", "x", 1).size(), 1U);
  EXPECT_EQ(decimal_range("0", "0.95", "0.3", "x", 9).back().text, "0.9");
  EXPECT_THROW(decimal_range("0", "1", "0", "x", 9), Error);
  EXPECT_THROW(decimal_range("1", "0", "1", "x", 9), Error);
  EXPECT_THROW(decimal_range("0", "1", "1e-300", "x", 9), Error);
  EXPECT_THROW(decimal_range("0", "inf", "1", "x", 9), Error);
  EXPECT_THROW(decimal_range("0", "1e-500", "1", "x", 9), Error);
}

TEST(Section, SaysWhatEachPlaneCuts) {
  const Folder folder;
  const std::string mesh = hollow_cube(folder);
  const Outcome o = run("$PLUMB section --plane z=0.1 --plane z=-10:10:10 --plane 1,1,0,0 " + mesh);
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, HasSubstr("1 of 5 planes are given by decimals that are no doubles"));
  std::map<std::string, std::string> rows;
  std::istringstream lines(o.out);
  for (std::string line; std::getline(lines, line);) rows[line.substr(0, line.find(' '))] = line;
  EXPECT_THAT(rows["z=0.1"], testing::MatchesRegex(" *z=0.1 +1 +1 +0 +16 +300 +120"));
  EXPECT_THAT(rows["z=-10"], testing::MatchesRegex("z=-10 +0 +0 +0 +0 +0 +0  2 triangles in the plane"));
  EXPECT_THAT(rows["z=10"], testing::MatchesRegex("z=10 +1 +0 +0 +4 +400 +80  2 triangles in the plane"));
  EXPECT_THAT(rows["1,1,0,0"],
              HasSubstr(" 424.264 "));  // 20 by 20 sqrt 2, less a quarter
}

TEST(Section, JsonHoldsContoursNestedAndCorners) {
  const Folder folder;
  const json report = section_of("--plane z=0 --plane 0,0,0,1,0,0,0,1,0 " + hollow_cube(folder));
  ASSERT_EQ(report.at("planes").size(), 2U);
  for (const json& plane : report.at("planes")) {
    const json& contours = plane.at("contours");
    ASSERT_EQ(contours.size(), 2U);
    const bool hole_first = contours[0].at("kind") == "hole";
    const json &outer = contours[hole_first ? 1 : 0], &hole = contours[hole_first ? 0 : 1];
    EXPECT_EQ(outer.at("kind"), "outer");
    EXPECT_EQ(outer.at("parent"), nullptr);
    EXPECT_EQ(hole.at("parent"), hole_first ? 1 : 0);
    EXPECT_EQ(outer.at("area"), 400.0);
    EXPECT_EQ(hole.at("area"), -100.0);
    EXPECT_EQ(outer.at("corners").size(), outer.at("cut_edges").size());
  }
  EXPECT_EQ(report.at("planes")[0].at("normal"), (json{0, 0, 1}));
  EXPECT_TRUE(report.at("planes")[1].contains("three_points"));
  EXPECT_TRUE(section_of("--below --plane z=10 " + (folder / "cube.obj")).at("planes")[0].at("contours").empty());
}

TEST(Section, DrawsLayersAndAFileEach) {
  const Folder folder;
  const std::string mesh = hollow_cube(folder), layers = folder / "layers.svg", out = folder / "out";
  const Outcome o = run("$PLUMB section --plane z=-9:9:3 --svg " + layers + " --out " + out + " " + mesh);
  EXPECT_EQ(o.code, 0) << o.err;
  const std::string svg = content(layers);
  EXPECT_THAT(svg, AllOf(StartsWith("<svg"), HasSubstr("inkscape:label=\"z=-9\""), HasSubstr("10,10")));
  std::size_t many = 0;
  for (std::size_t at = 0; (at = svg.find("<path", at)) != std::string::npos; ++at) ++many;
  EXPECT_EQ(many, 7U);
  EXPECT_THAT(content(out + "/section-0007.svg"), AllOf(StartsWith("<svg"), HasSubstr("<title>z=9</title>")));
  EXPECT_EQ(content(out + "/section-0008.svg"), "");
}

// A line is a pixel wide where the picture has its own size, 900 pixels along the larger side, however large the mesh is.
TEST(Section, DrawsLinesOfAShareOfTheDrawing) {
  const Folder folder;
  for (const double size : {1e-150, 1e-9, 0.001, 1.0, 12'345.0, 1e9, 1e150}) {
    TriangleMesh mesh = solids::box({-size, -size, -size}, {3 * size, size, size});
    mesh.triangles.pop_back();  // an open chain as well
    write_mesh(folder / "box.obj", mesh);
    const std::string out = folder / "out";
    const Outcome o =
        run("$PLUMB section --plane 0,0,1,0 --plane 1,0,0,0 --svg - --out " + out + " " + (folder / "box.obj"));
    EXPECT_EQ(o.code, 0) << o.err;
    for (const std::string& svg : {o.out, content(out + "/section-0001.svg"), content(out + "/section-0002.svg")}) {
      const SvgLines drawn = svg_lines(svg);
      ASSERT_EQ(drawn.widths.size(), 1U) << svg;
      EXPECT_NEAR(drawn.widths[0] * 900 / drawn.larger_side, 1, 1e-12) << size;
      EXPECT_GE(drawn.larger_side, 4 * size) << size;
      EXPECT_LE(drawn.larger_side, 4.5 * size) << size;
      for (const char* word : {"vector-effect", "<style", "px"}) EXPECT_EQ(svg.find(word), svg.npos) << word;
    }
    for (const char* stroke : {"stroke=\"#224466\"", "stroke=\"#cc3311\""})
      EXPECT_NE(o.out.find(stroke), o.out.npos) << o.out;
  }
}

TEST(Section, ReplacesTheFolderOnlyWithTheFilesBesideIt) {
  const Folder folder;
  const std::string mesh = hollow_cube(folder), out = folder / "out";
  const std::string line = "$PLUMB section --out " + out + " " + mesh + " --plane ";
  EXPECT_EQ(run(line + "z=0").code, 0);
  const std::string first = content(out + "/section-0001.svg");
  for (const std::string fails : {"z=1 --json - >/dev/full", "z=1 --svg s.svg >/dev/full", "z=1 --dxf no/such"}) {
    EXPECT_EQ(run(line + fails).code, 2) << fails;
    EXPECT_EQ(content(out + "/section-0001.svg"), first) << fails;
  }
  EXPECT_EQ(run(line + "z=0 --plane z=1").code, 0);
  for (const std::string name : {"/section-0001.svg", "/section-0002.svg"}) {  // this report's, and an older one's
    const Outcome same = run(line + "z=1 --svg " + out + name);
    EXPECT_EQ(same.code, 2);
    EXPECT_THAT(same.err, HasSubstr("the same output"));
    EXPECT_EQ(content(out + "/section-0001.svg"), first);
    EXPECT_NE(content(out + "/section-0002.svg"), "");
  }
}

TEST(Section, DxfHoldsClosedPolylines) {
  const Folder folder;
  const Outcome o = run("$PLUMB section --plane z=1.5 --plane x=2 --dxf - " + hollow_cube(folder));
  EXPECT_EQ(o.code, 0) << o.err;
  // Codes and values, line by line, as a reader takes them.
  std::istringstream lines(o.out);
  std::vector<std::pair<int, std::string>> groups;
  for (std::string code, value; std::getline(lines, code) && std::getline(lines, value);)
    groups.emplace_back(std::stoi(code), value);
  ASSERT_EQ(groups.back(), std::pair(0, std::string("EOF")));
  std::vector<int> flags;
  int vertices = 0, ends = 0;
  double z = 0;
  std::string entity;
  for (const auto& [code, value] : groups) {
    if (code == 0) entity = value;
    vertices += code == 0 && value == "VERTEX";
    ends += code == 0 && value == "SEQEND";
    if (code == 70 && entity == "POLYLINE") flags.push_back(std::stoi(value));
    if (code == 30 && entity == "VERTEX" && flags.back() == 1) z = std::stod(value);
  }
  EXPECT_EQ(flags, (std::vector<int>{1, 1, 9, 9}));
  EXPECT_EQ(vertices, 32);
  EXPECT_EQ(ends, 4);
  EXPECT_EQ(z, 1.5);
}

TEST(Section, RoundsTheViewOfAnObliquePlaneOnce) {
  std::mt19937_64 random(5);
  const TriangleMesh mesh = solids::heap(random, 6, 9);
  const Plane3 plane{{1, 2, 3}, 1};
  const Section cut = section(mesh, plane);
  const SectionView view(plane);
  int seen = 0;
  for (const Contour& c : cut.contours) {
    for (const SectionCorner& corner : c.corners) {
      const RationalPoint3 p = rational_point(exact_corner(mesh, plane, corner));
      const Point2 q = view.at(mesh, corner);
      // u runs along (-2, 1, 0): its square times 5 is that of -2 x + y; the
      // doubles beside it are farther.
      const Rational along = p.y - Rational(2) * p.x;
      EXPECT_EQ(along.sign(), Rational(q.x).sign());
      const double low = std::nextafter(std::fabs(q.x), 0), high = std::nextafter(std::fabs(q.x), 1e9);
      EXPECT_TRUE(Rational(low) * Rational(low) * Rational(5) < along * along || q.x == 0);
      EXPECT_TRUE(along * along < Rational(high) * Rational(high) * Rational(5));
      // Distances in the view are those in space.
      const double x = p.x.rounded(), y = p.y.rounded(), z = p.z.rounded();
      EXPECT_NEAR(q.x * q.x + q.y * q.y, x * x + y * y + z * z - 1.0 / 14, 1e-9);
      ++seen;
    }
  }
  EXPECT_GT(seen, 10);
}

TEST(Section, ReadsStandardInput) {
  const Folder folder;
  const Outcome o = run("$PLUMB section --plane z=0 -", content(hollow_cube(folder)));
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, AllOf(HasSubstr("standard input"), HasSubstr(" 300 ")));
}

TEST(Section, TellsOpenMeshes) {
  const Folder folder;
  std::ofstream(folder / "one.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n";
  const Outcome o = run("$PLUMB section --plane z=0.5 --svg " + (folder / "s.svg") + " " + (folder / "one.obj"));
  EXPECT_EQ(o.code, 0);
  EXPECT_THAT(o.out, AllOf(HasSubstr("open"), HasSubstr("1 of 1 sections are open")));
  EXPECT_THAT(content(folder / "s.svg"), HasSubstr("class=\"open\""));
}

TEST(Section, RefusesWhatItCannotRead) {
  const Folder folder;
  const std::string mesh = hollow_cube(folder);
  for (const auto& [arguments, words] : std::vector<std::pair<std::string, std::string>>{
           {mesh, "a --plane is needed"},
           {"--plane z=1", "one MESH is needed"},
           {"--plane z=1 " + mesh + " " + mesh, "one MESH is needed"},
           {"--plane w=1 " + mesh, "--plane w=1: the axis is x, y or z; a plane is z=HEIGHT,"},
           {"--plane z=0:1 " + mesh, "a range is start:stop:step"},
           {"--plane z=1:0:0.1 " + mesh, "ends at 0, below 1"},
           {"--plane z=0:1:-0.1 " + mesh, "is not positive"},
           {"--plane z=0:1:1e-9 " + mesh, "take a longer step"},
           {"--plane 1,2,3 " + mesh, "this has 3 numbers"},
           {"--plane 0,0,0,1 " + mesh, "zero normal"},
           {"--plane 0,0,0,1,1,1,2,2,2 " + mesh, "on one line"},
           {"--plane z=nan " + mesh, "not a decimal number"},
           {"--plane z=1e999 " + mesh, "beyond the largest double"},
           {"--plane z=1 --svg a.svg --dxf a.svg " + mesh, "name the same output"},
           {"--plane z=1 nope.obj", "nope.obj"}}) {
    const Outcome o = run("$PLUMB section " + arguments);
    EXPECT_EQ(o.code, 2) << arguments;
    EXPECT_EQ(o.out, "");
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words))) << arguments;
    EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1);
  }
}

}  // namespace
}  // namespace plumb::tool
