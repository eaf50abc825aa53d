// Does `plumb bsp` tell of a file's mesh what its tree is like?
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>

#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

std::string in(const Folder& folder) {
  std::ofstream(folder / "block.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  std::ofstream(folder / "open.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
  return "cd " + (folder / "") + " && $PLUMB bsp ";
}

TEST(BspCommand, TellsTheFigures) {
  const Folder folder;
  const Outcome o = run(in(folder) + "block.obj");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, AllOf(HasSubstr("block.obj: 4 vertices, 4 triangles, closed\n"),
                           HasSubstr("4 planes, 0 of them across axes; 4 deep\n"),
                           HasSubstr("5 leaves, 1 of them solid; 4 pieces of faces, after 0 splits\n"),
                           HasSubstr("longest chain of planes with a leaf beside each: 4\n")));
}

TEST(BspCommand, WritesThemAsJson) {
  const Folder folder;
  const json said = json::parse(run(in(folder) + "--leaves pieces --leaf-size 1 --json - open.obj").out);
  EXPECT_EQ(said.at("program"), "plumb bsp");
  EXPECT_EQ(said.at("leaves_tell"), "pieces");
  EXPECT_EQ(said.at("solid_leaves"), 0);
  EXPECT_EQ(said.at("leaf_size"), 1);
  EXPECT_GE(said.at("pieces_of_faces"), 3);
  EXPECT_EQ(said.at("leaves"), said.at("nodes").get<int>() + 1);
  EXPECT_GE(said.at("build_ms"), 0);
  const json none = json::parse(run(in(folder) + "--leaves none --planes faces --json - open.obj").out);
  EXPECT_EQ(none.at("axis_nodes"), 0);
  EXPECT_EQ(none.at("pieces_of_faces"), 3);
}

TEST(BspCommand, RefusesWhatItCannotDo) {
  const Folder folder;
  const std::string at = in(folder);
  const std::pair<const char*, const char*> refusals[] = {{"", "one MESH is needed"},
                                                          {"block.obj block.obj", "one MESH is needed"},
                                                          {"open.obj", "open.obj: build_bsp: the mesh is not closed"},
                                                          {"--leaves some block.obj", "--leaves"},
                                                          {"--split-weight 2 block.obj", "--split-weight"},
                                                          {"absent.obj", "absent.obj"}};
  for (const auto& [line, words] : refusals) {
    const Outcome o = run(at + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_EQ(o.out, "") << line;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words))) << line;
  }
}

}  // namespace
}  // namespace plumb::tool
