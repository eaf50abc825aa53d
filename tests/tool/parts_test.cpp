// Does `plumb parts` tell and write the convex parts of a file's solid, and hulls that cover it?
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>

#include "figure/basic/solids.hpp"
#include "plumb/surface/file/read_mesh.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

/// An L, 1 high, of volume 5.
constexpr auto ell =
    "v 0 0 0\nv 3 0 0\nv 3 1 0\nv 1 1 0\nv 1 3 0\nv 0 3 0\nv 0 0 1\nv 3 0 1\nv 3 1 1\nv 1 1 1\nv 1 3 1\nv 0 3 1\n"
    "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n";

std::string in(const Folder& folder) {
  std::ofstream(folder / "ell.obj") << ell;
  TriangleMesh open = solids::box({0, 0, 0}, {1, 1, 1});
  write_mesh(folder / "cube.obj", open);
  open.triangles.pop_back();
  write_mesh(folder / "open.obj", open);
  return "cd " + (folder / "") + " && $PLUMB parts ";
}

TEST(PartsCommand, SaysTheConvexParts) {
  const Folder folder;
  const Outcome o = run(in(folder) + "ell.obj");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_EQ(o.out,
            "ell.obj: 12 vertices, 20 triangles, closed\n"
            "1 notch, 1 cut: 2 convex parts\n"
            "    part vertices    faces                   volume\n"
            "       0        8        6                        3\n"
            "       1        8        6                        2\n");
  EXPECT_THAT(run(in(folder) + "cube.obj").out, HasSubstr("0 notches, 0 cuts: 1 convex part\n"));
}

TEST(PartsCommand, WritesPartsThatAreClosedAndConvex) {
  const Folder folder;
  const std::string at = in(folder);
  ASSERT_EQ(run(at + "ell.obj --obj parts.obj").code, 0);
  EXPECT_THAT(content(folder / "parts.obj"),
              AllOf(HasSubstr("o part-0\n"), HasSubstr("o part-1\n"), Not(HasSubstr("o part-2\n"))));
  const Outcome o = run("cd " + (folder / "") + " && $PLUMB check --brief parts.obj");
  EXPECT_LE(o.code, 1) << o.err;
  EXPECT_EQ(run(at + "ell.obj --obj parts.obj").code, 2);
  EXPECT_EQ(run(at + "ell.obj --obj parts.obj --overwrite").code, 0);
}

TEST(PartsCommand, CoversWithHulls) {
  const Folder folder;
  const json one = json::parse(run(in(folder) + "--most 1 --json - ell.obj").out);
  EXPECT_EQ(one.at("program"), "plumb parts");
  EXPECT_EQ(one.at("convex_parts"), 2);
  ASSERT_EQ(one.at("solid_parts").size(), 1u);
  EXPECT_EQ(one.at("solid_parts")[0].at("volume"), 7.0);
  EXPECT_EQ(one.at("solid_parts")[0].at("share"), (json{0, 1}));
  const double concavity = one.at("solid_parts")[0].at("concavity");
  EXPECT_GE(concavity, 0.999);
  EXPECT_LE(concavity, 1.1);
  const json two = json::parse(run(in(folder) + "--concavity 0.5 --json - ell.obj").out);
  EXPECT_EQ(two.at("solid_parts").size(), 2u);
  for (const int part : {0, 1}) {  // counted from 0, in the table and as shares
    EXPECT_THAT(run(in(folder) + "--concavity 0.5 ell.obj").out, HasSubstr(fmt::format("\n{:>8}        8", part)));
    EXPECT_EQ(two.at("solid_parts")[static_cast<std::size_t>(part)].at("share"), json{part});
  }
  EXPECT_THAT(run(in(folder) + "--concavity 2 ell.obj").out, HasSubstr("2 convex parts, covered by 1 hull\n"));
}

TEST(PartsCommand, RefusesWhatItCannotDo) {
  const Folder folder;
  const std::string at = in(folder);
  const std::pair<const char*, const char*> refusals[] = {{"", "one MESH is needed"},
                                                          {"ell.obj cube.obj", "one MESH is needed"},
                                                          {"open.obj", "open"},
                                                          {"none.obj", "none.obj"},
                                                          {"--concavity -1 ell.obj", "-1 is negative"},
                                                          {"--concavity nan ell.obj", "'nan' is not a decimal number"},
                                                          {"--most 0 ell.obj", "--most"},
                                                          {"ell.obj --obj parts.stl", "another format"}};
  for (const auto& [line, words] : refusals) {
    const Outcome o = run(at + line);
    EXPECT_EQ(o.code, 2) << line;
    EXPECT_EQ(o.out, "") << line;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words))) << line;
  }
}

}  // namespace
}  // namespace plumb::tool
