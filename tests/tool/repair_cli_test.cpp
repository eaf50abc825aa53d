// `plumb repair` as a user meets it: files and folders that are mended, what is told, and what is not replaced.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/topology/faults.hpp"
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

TEST(RepairCommand, StandardInputAndOutput) {
  const Folder folder;
  put(folder / "a.obj", broken);
  const Outcome o = run("$PLUMB repair - -o - < " + (folder / "a.obj"));
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, StartsWith("v 0 0 0\n"));
}

}  // namespace
}  // namespace plumb::tool
