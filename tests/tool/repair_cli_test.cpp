// `plumb repair` as a user meets it: files and folders that are mended, what is told, and what is not replaced.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "plumb/figure/measures/width.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/topology/faults.hpp"
#include "tool/browser.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

void put(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

/// A tetrahedron, one of its triangles turned over, one missing, with a vertex that no triangle names.
const char* const broken = "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nv 9 9 9\nf 1 3 2\nf 1 2 4\nf 1 3 4\n";
const char* const whole = "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

TEST(RepairCommand, MendsAFileAndTellsEachChange) {
  const Folder folder;
  put(folder / "a.obj", broken);
  const Outcome o =
      run("$PLUMB repair " + (folder / "a.obj") + " -o " + (folder / "b.ply") + " --json " + (folder / "r.json"));
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, AllOf(HasSubstr("was         not closed, not oriented"), HasSubstr("hole filled: 1\n"),
                           HasSubstr("turned to agree: 1\n"), HasSubstr("unused vertex left out: 1\n"),
                           HasSubstr("is          closed, oriented, free of self-intersections")));
  const TriangleMesh mended = read_mesh(folder / "b.ply");
  EXPECT_FALSE(find_faults(mended).any());
  EXPECT_EQ(mended.vertices.size(), 4U);
  EXPECT_THAT(content(folder / "r.json"), AllOf(HasSubstr("\"hole filled\""), HasSubstr("\"defects_after\": []")));
  EXPECT_EQ(content(folder / "a.obj"), broken);
}

TEST(RepairCommand, APageShowsTheMeshBeforeAndAfterAndLeadsToEachChange) {
  const Folder folder;
  put(folder / "a.obj", broken);
  put(folder / "b.obj", whole);
  const std::string all = "$PLUMB repair " + (folder / "a.obj") + " " + (folder / "b.obj");
  const Outcome o = run(all + " --dry-run --page " + (folder / "p.html"));
  EXPECT_EQ(o.code, 0) << o.err;
  const std::string page = content(folder / "p.html");
  EXPECT_THAT(page, AllOf(StartsWith("<!DOCTYPE html>"), testing::EndsWith("</html>\n"), HasSubstr("hole filled")));
  EXPECT_THAT(page, Not(testing::AnyOf(HasSubstr("http:"), HasSubstr("https:"), HasSubstr("src=\""))));
  const Outcome again = run(all + " --dry-run --page " + (folder / "p.html"));
  EXPECT_EQ(again.code, 2) << "no file is replaced that was not to be";
  EXPECT_THAT(again.err, HasSubstr("p.html"));
  EXPECT_EQ(content(folder / "p.html"), page);
  EXPECT_EQ(run(all + " -o " + (folder / "out") + " --overwrite --page " + (folder / "p.html")).code, 0);
  EXPECT_FALSE(find_faults(read_mesh(folder / "out/a.obj")).any());
  if (!has_browser()) return;
  const Outcome shown = in_browser(page, R"(addEventListener('DOMContentLoaded', () => {
const painted = id => {
  const canvas = document.getElementById(id), data = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  let green = 0, any = 0;
  for (let i = 0; i < data.length; i += 4) any += data[i + 3] > 0, green += data[i + 3] > 0 && data[i + 1] > 60 && data[i] < 20;
  return [any > 2000, green > 200];
};
const rows = [...document.querySelectorAll('tr[data-mesh="0"]')], told = document.getElementById('told');
const result = [painted('before'), painted('after'), told.textContent];
const hole = rows.findIndex(row => row.dataset.change === 'hole filled');
rows[hole].querySelector('button').click();
const ring = document.getElementById('after').marks.find(([x, y, k]) => k === hole);
result.push(Math.abs(ring[0] - 260) < 1 && Math.abs(ring[1] - 210) < 1, told.textContent.startsWith('hole filled'), rows[hole].classList.contains('fails'), painted('after'));
document.querySelector('input[value="hole filled"]').click();
const chooser = document.getElementById('mesh');
chooser.value = 1;
chooser.dispatchEvent(new Event('change'));
result.push(document.getElementById('was').textContent.startsWith('before: closed'), painted('after'));
document.title = result.flat().join();
});)");
  EXPECT_EQ(shown.code, 0) << shown.err;
  EXPECT_THAT(shown.err, Not(HasSubstr("CONSOLE")));
  EXPECT_THAT(shown.out, HasSubstr("<title>true,false,true,true,,true,true,true,true,true,true,true,false</title>"));
}

TEST(RepairCommand, ADryRunWritesNothing) {
  const Folder folder;
  put(folder / "a.obj", broken);
  const Outcome o = run("cd " + (folder / "") + " && $PLUMB repair --dry-run a.obj && ls");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, AllOf(HasSubstr("hole filled: 1"), HasSubstr("\na.obj\n")));
  EXPECT_THAT(o.out, Not(HasSubstr("written")));
}

TEST(RepairCommand, FoldersBecomeFolders) {
  const Folder folder;
  ASSERT_EQ(run("mkdir -p " + (folder / "in/deep")).code, 0);
  put(folder / "in/a.obj", broken);
  put(folder / "in/deep/b.obj", whole);
  const Outcome o = run("$PLUMB repair " + (folder / "in") + " -o " + (folder / "out"));
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_FALSE(find_faults(read_mesh(folder / "out/a.obj")).any());
  EXPECT_THAT(o.out, HasSubstr("changed     nothing"));
  EXPECT_TRUE(read_mesh(folder / "out/b.obj").triangles == read_mesh(folder / "in/deep/b.obj").triangles);
  const Outcome again = run("$PLUMB repair " + (folder / "in") + " -o " + (folder / "out"));
  EXPECT_EQ(again.code, 2);
  EXPECT_THAT(again.err, HasSubstr("is there already"));
  EXPECT_EQ(run("$PLUMB repair --overwrite " + (folder / "in") + " -o " + (folder / "out")).code, 0);
}

TEST(RepairCommand, StepsAloneAndWhatIsLeft) {
  const Folder folder;
  put(folder / "a.obj", broken);
  const std::string a = folder / "a.obj";
  const Outcome o = run("$PLUMB repair --only unused,orientation --fail-on-left " + a + " -o " + (folder / "b.obj"));
  EXPECT_EQ(o.code, 1) << "still open";
  EXPECT_EQ(read_mesh(folder / "b.obj").triangles.size(), 3U);
  EXPECT_EQ(run("$PLUMB repair --only holes,orientation --fail-on-left " + a + " -o " + (folder / "c.obj")).code, 0);
  EXPECT_EQ(read_mesh(folder / "c.obj").vertices.size(), 5U);
}

TEST(RepairCommand, WhatCannotBeIsRefusedAndWritesNothing) {
  const Folder folder;
  put(folder / "a.obj", broken);
  put(folder / "bad.obj", "v 0 0\n");
  const std::string a = folder / "a.obj", b = folder / "b.obj";
  for (const auto& [words, why] : std::vector<std::pair<std::string, std::string>>{
           {a, "'-o FILE'"},
           {"-o " + b, "no mesh is named"},
           {a + " -o " + a, "which this run reads"},
           {a + " -o " + (folder / "bad.obj"), "is there already"},
           {a + " -o " + (folder / "b.glb"), "b.glb"},
           {a + " --tolerance -1 -o " + b, "--tolerance"},
           {a + " --tolerance nan -o " + b, "--tolerance"},
           {a + " --only polish -o " + b, "polish"},
           {a + " --only zip -o " + b, "--tolerance LENGTH"},
           {a + " --only small-components -o " + b, "--smallest N"},
           {a + " --dry-run -o " + b, "exclude one another"},
           {a + " " + a + " -o -", "takes one mesh"},
           {a + " " + (folder / "bad.obj") + " -o " + (folder / "out"), "bad.obj"}}) {
    const Outcome o = run("$PLUMB repair " + words);
    EXPECT_EQ(o.code, 2) << words;
    EXPECT_THAT(o.err, HasSubstr(why)) << words;
    EXPECT_EQ(run("test -e " + b + " || test -e " + (folder / "out")).code, 1) << words;
  }
}

TEST(RepairCommand, PolygonsThatAreNotPlanarAreRefusedWhereThatIsAsked) {
  const Folder folder;
  // A box whose lid has one corner 2^-4 too low: the lid and two walls are quadrilaterals, the lid alone is not planar.
  put(folder / "a.obj",
      "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 0 0 4\nv 4 0 4\nv 4 4 4\nv 0 4 3.9375\n"
      "f 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 5 6 7 8\n");
  const std::string a = folder / "a.obj", b = folder / "b.obj";
  const Outcome o = run("$PLUMB repair --planar 0 " + a + " -o " + b);
  EXPECT_EQ(o.code, 2);
  const std::vector<Point3> lid{{0, 0, 4}, {4, 0, 4}, {4, 4, 4}, {0, 4, 3.9375}};
  const double thick = least_width(lid).width;
  EXPECT_THAT(o.err, AllOf(HasSubstr("a.obj: polygon 5, counted from 0, is "), HasSubstr("'--planar 0'")));
  EXPECT_THAT(o.err, HasSubstr(fmt::format("is {} thick", thick)));
  EXPECT_EQ(run("test -e " + b).code, 1) << "nothing is written";
  EXPECT_EQ(run(fmt::format("$PLUMB repair --planar {} {} -o {}", std::nextafter(thick, 0), a, b)).code, 2);
  EXPECT_EQ(run(fmt::format("$PLUMB repair --planar {} {} -o {}", thick + 1e-9, a, b)).code, 0);
  EXPECT_EQ(read_mesh(b).triangles.size(), 12U);
  EXPECT_EQ(run("$PLUMB repair --dry-run " + a).code, 0) << "triangulated, where it is not asked for";
  for (const char* words : {"-1", "nan", "inf", "x"})
    EXPECT_EQ(run(std::string("$PLUMB repair --dry-run --planar ") + words + " " + a).code, 2) << words;
}

TEST(RepairCommand, GoesOnBehindAMeshThatIsNotPlanar) {
  const Folder folder;
  put(folder / "a.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 1\nf 1 2 3 4\n");
  put(folder / "b.obj", broken);
  put(folder / "c.obj", "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 2\nf 1 2 3 4\n");
  const std::string at = "cd " + (folder / "") + " && $PLUMB repair --planar 0.01 ";
  const Outcome o = run(at + "a.obj b.obj c.obj -o out");
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, AllOf(HasSubstr("a.obj: polygon 0"), HasSubstr("c.obj: polygon 0")));
  EXPECT_THAT(o.out, AllOf(HasSubstr("b.obj\n"), HasSubstr("hole filled: 1")));
  EXPECT_EQ(run("test -e " + (folder / "out")).code, 1) << "nothing is written";
  EXPECT_EQ(run("cd " + (folder / "") + " && mkdir in && mv *.obj in").code, 0);
  const Outcome of_folder = run(at + "--json report.json in -o out");  // what a folder holds is reported on
  EXPECT_EQ(of_folder.code, 2);
  EXPECT_FALSE(find_faults(read_mesh(folder / "out/b.obj")).any());
  EXPECT_EQ(run("ls " + (folder / "out")).out, "b.obj\n");
  const json report = json::parse(content(folder / "report.json"));
  EXPECT_EQ(report.at("meshes").size(), 1U);
  ASSERT_EQ(report.at("not_read").size(), 2U);
  EXPECT_EQ(report.at("not_read")[1].at("mesh"), "in/c.obj");
  EXPECT_THAT(std::string(report.at("not_read")[1].at("error")), HasSubstr("polygon 0"));
}

TEST(RepairCommand, StandardInputAndOutput) {
  const Folder folder;
  put(folder / "a.obj", broken);
  const Outcome o = run("$PLUMB repair - -o - < " + (folder / "a.obj"));
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, StartsWith("v 0 0 0\n"));
}

}  // namespace
}  // namespace plumb::tool
