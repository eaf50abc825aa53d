// `plumb repair --shard` as a user meets it: every model mended once under its own path, whatever the number of shards,
// also where a run is stopped between a mesh and its line; and nothing of others is replaced.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "figure/basic/solids.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;

/// A box, one that lacks a face, a sheet, and a file that is no mesh.
std::string with_models(const Folder& folder) {
  fs::create_directories(folder / "models/more");
  write_mesh(folder / "models/box.stl", solids::box({0, 0, 0}, {1, 1, 1}));
  TriangleMesh open = solids::box({0, 0, 0}, {2, 1, 1});
  open.triangles.pop_back();
  write_mesh(folder / "models/more/open.obj", open);
  write_mesh(folder / "models/more/box.ply", solids::box({0, 0, 0}, {1, 3, 1}));
  std::ofstream(folder / "models/broken.stl") << "solid none\nfacet\n";
  return "cd " + (folder / "") + " && ";
}

TEST(RepairShards, MendEachModelOnce) {
  const Folder folder;
  const std::string at = with_models(folder);
  std::string first;
  for (const int n : {1, 3}) {
    const std::string out = "out" + std::to_string(n);
    for (int i = 1; i <= n; ++i)
      ASSERT_EQ(
          run(at + "$PLUMB repair models -q --shard " + std::to_string(i) + "/" + std::to_string(n) + " --out " + out)
              .code,
          0);
    const Outcome o = run(at + "$PLUMB collect " + out);
    EXPECT_EQ(o.code, 0) << o.err;
    EXPECT_THAT(o.out, AllOf(StartsWith("plumb repair of models: 4 models in "), HasSubstr("mended"),
                             HasSubstr("sound"), HasSubstr("unreadable")));
    const std::string digest = o.out.substr(o.out.find("digest "));
    if (n == 1) first = digest;
    EXPECT_EQ(digest, first);
    EXPECT_TRUE(fs::exists(folder / (out + "/mended/box.stl")));
    EXPECT_TRUE(fs::exists(folder / (out + "/mended/more/box.ply")));
    EXPECT_EQ(run(at + "$PLUMB check -q --fail-on-defect open " + out + "/mended/more/open.obj").code, 0);
  }
}

TEST(RepairShards, ReplaceNothing) {
  const Folder folder;
  const std::string at = with_models(folder), repair = at + "$PLUMB repair models --shard 1/1 --out out ";
  fs::create_directories(folder / "out/mended/more");
  std::ofstream(folder / "out/mended/more/open.obj") << "my own\n";
  ASSERT_EQ(run(repair).code, 0);
  EXPECT_EQ(content(folder / "out/mended/more/open.obj"), "my own\n");
  const std::string file = folder / "out/repair.1-of-1.jsonl", whole = content(file);
  EXPECT_THAT(whole, AllOf(HasSubstr("\"refused\""), HasSubstr("is not written")));
  // A run that was killed behind a mesh, and before its line.
  const std::size_t line = whole.find("\"model\":\"more/box.ply\"");
  ASSERT_NE(line, whole.npos);
  std::ofstream(file) << whole.substr(0, whole.rfind('\n', line) + 1);
  ASSERT_EQ(run(repair).code, 0);
  EXPECT_THAT(run(at + "$PLUMB collect out").out, AllOf(HasSubstr("sound"), HasSubstr("of 4 models")));
  const Outcome within = run(at + "$PLUMB repair models --shard 1/1 --out models/out");
  EXPECT_EQ(within.code, 2);
  EXPECT_THAT(within.err, HasSubstr("lies in the folder of models"));
  EXPECT_EQ(run(repair + "-o other.obj").code, 2);
}

}  // namespace
}  // namespace plumb::tool
