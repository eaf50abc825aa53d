// `plumb collect` as a user meets it: one digest for any number of shards in any order, the worst first, what is not
// done by its number, and what does not belong together.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "figure/basic/solids.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;

/// Boxes, a sheet that is open, and a file that is no mesh.
std::string with_models(const Folder& folder) {
  fs::create_directories(folder / "models/more");
  for (int k = 0; k < 9; ++k)
    write_mesh(folder / ("models/more/box" + std::to_string(k) + ".obj"), solids::box({0, 0, 0}, {k + 1.0, 1, 1}));
  std::ofstream(folder / "models/open.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  std::ofstream(folder / "models/<b>&.stl") << "solid none\nfacet\n";
  return "cd " + (folder / "") + " && ";
}

void check_in_shards(const std::string& at, const std::string& out, int n, int skip = 0) {
  for (int i = n; i >= 1; --i) {
    if (i == skip) continue;
    const Outcome o = run(at + "$PLUMB check models -q --shard " + std::to_string(i) + "/" + std::to_string(n) +
                          " --out " + out + " --time-limit 60");
    ASSERT_EQ(o.code, 0) << o.err;
  }
}

std::string digest_in(const std::string& text) {
  const std::size_t at = text.find("digest ");
  return at == text.npos ? "none" : text.substr(at + 7, 16);
}

TEST(Collect, HasOneDigestForAnyNumberOfShards) {
  const Folder folder;
  const std::string at = with_models(folder);
  std::string first;
  for (const int n : {1, 2, 3, 7}) {
    const std::string out = "out" + std::to_string(n);
    check_in_shards(at, out, n);
    const Outcome o = run(at + "$PLUMB collect " + out + " --json out.json --csv out.csv --page out.html");
    ASSERT_EQ(o.code, 0) << o.err;
    const json report = json::parse(content(folder / "out.json"));
    const auto digest = report.at("findings_digest").get<std::string>();
    if (n == 1) first = digest;
    EXPECT_EQ(digest, first) << n;
    EXPECT_EQ(digest_in(o.out), first);
    EXPECT_EQ(report.at("model_count"), 11);
    EXPECT_EQ(report.at("shard_count"), n);
    EXPECT_THAT(o.out, AllOf(StartsWith("plumb check of models: 11 models in "), HasSubstr("sound"),
                             HasSubstr("open.obj: faulty (open): 3 open edges")));
    EXPECT_LT(o.out.find("<b>&.stl: unreadable"), o.out.find("open.obj: faulty"));
    const std::string csv = content(folder / "out.csv"), page = content(folder / "out.html");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 12);
    EXPECT_THAT(page, AllOf(HasSubstr("&lt;b&gt;&amp;.stl"), Not(HasSubstr("<b>&.stl</td>")), HasSubstr(first)));
  }
  // What is found changes it; when and how long does not.
  std::ofstream(folder / "models/open.obj") << "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 1 1 1\nf 1 2 3\nf 1 2 4\n";
  check_in_shards(at, "changed", 2);
  EXPECT_NE(digest_in(run(at + "$PLUMB collect changed").out), first);
}

TEST(Collect, TellsWhatIsNotDone) {
  const Folder folder;
  const std::string at = with_models(folder);
  check_in_shards(at, "out", 3, 2);
  const Outcome missing = run(at + "$PLUMB collect out --json -");
  EXPECT_EQ(missing.code, 1) << missing.err;
  EXPECT_EQ(json::parse(missing.out).at("unfinished_shards"), json({2}));
  check_in_shards(at, "out", 3);
  EXPECT_EQ(run(at + "$PLUMB collect out -q").code, 0);
  // A run that was killed left neither its last line nor all of the one before.
  const std::string file = folder / "out/check.3-of-3.jsonl";
  const std::string whole = content(file);
  std::ofstream(file) << whole.substr(0, whole.find("{\"done\"") - 5);
  const Outcome killed = run(at + "$PLUMB collect out");
  EXPECT_EQ(killed.code, 1);
  EXPECT_THAT(killed.out, HasSubstr("not at their end: 3/3;"));
}

TEST(Collect, RefusesWhatDoesNotBelongTogether) {
  const Folder folder;
  const std::string at = with_models(folder);
  const auto refused = [&](const std::string& words, const std::string& why) {
    const Outcome o = run(at + "$PLUMB collect " + words + " --json report.json");
    EXPECT_EQ(o.code, 2) << words;
    EXPECT_THAT(o.err, HasSubstr(why)) << words;
    EXPECT_FALSE(fs::exists(folder / "report.json"));
  };
  refused("", "one; 'plumb collect --help'");
  refused("models models", "one; 'plumb collect --help'");
  refused("nowhere", "cannot be read");
  refused("models", "holds no shard");
  check_in_shards(at, "out", 2);
  const std::string file = folder / "out/check.1-of-2.jsonl", kept = content(file);
  const std::string other = folder / "out/check.2-of-2.jsonl", second = content(other);
  const std::string line = second.substr(second.find('\n') + 1);
  std::ofstream(file, std::ios::app) << line.substr(0, line.find('\n') + 1);
  refused("out", "another line tells of ");
  std::string title = kept;
  std::ofstream(file) << title.replace(title.find("\"models\""), 8, "\"others\"");
  refused("out", "another corpus");
  std::ofstream(file) << "nothing\n";
  refused("out", "line 1 is none of a shard");
  std::ofstream(file) << kept;
  std::ofstream(folder / "out/check.1-of-5.jsonl") << kept;
  refused("out", "another number of shards");
}

}  // namespace
}  // namespace plumb::tool
