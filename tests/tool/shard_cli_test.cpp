// `plumb check --shard` as a user meets it: each model once, whatever the number of shards, however often a run is
// killed, and whatever a model does to the process that looks at it; what is refused and never replaced.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "certify/sanitized.hpp"
#include "figure/basic/solids.hpp"
#include "plumb/surface/file/write_mesh.hpp"
#include "tool/corpus/limited_process.hpp"
#include "tool/corpus/shard.hpp"
#include "tool/matchers.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;
using Findings = std::map<std::string, json>;

/// Boxes in folders, one open, one that is no mesh, one whose name is no UTF-8.
std::string with_corpus(const Folder& folder, int boxes = 20) {
  const fs::path corpus = folder / "corpus";
  for (int k = 0; k < boxes; ++k) {
    const fs::path place = corpus / std::to_string(k % 3);
    fs::create_directories(place);
    const double x = k + 1;
    write_mesh(place / ("box" + std::to_string(k) + ".obj"), solids::box({0, 0, 0}, {x, 1, 1}));
  }
  std::ofstream(corpus / "open.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  std::ofstream(corpus / "broken.stl") << "solid none\nfacet\n";
  std::ofstream(corpus / "caf\xe9.off") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  std::ofstream(corpus / "notes.txt") << "none\n";
  return "cd " + (folder / "") + " && ";
}

/// What stands in the files of shards, without what is measured; no model may be there twice.
Findings found_in(const std::string& folder) {
  Findings findings;
  for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
    std::ifstream in(file.path());
    std::string line;
    while (std::getline(in, line)) {
      json found = json::parse(line);
      if (!found.contains("model")) continue;
      EXPECT_TRUE(found.at("measured").at("seconds").is_number());
      found.erase("measured");
      const auto [at, is_new] = findings.emplace(found.at("model").get<std::string>(), found);
      EXPECT_TRUE(is_new) << at->first << " is there twice";
    }
  }
  return findings;
}

std::string verdict_of(const Findings& findings, const std::string& model) {
  return findings.contains(model) ? findings.at(model).at("verdict").get<std::string>() : "none";
}

TEST(Shards, HoldEachModelOnceWhateverTheirNumber) {
  const Folder folder;
  const std::string at = with_corpus(folder);
  Findings first;
  for (const int n : {1, 2, 3, 7}) {
    const std::string out = "out" + std::to_string(n);
    for (int i = n; i >= 1; --i) {  // in an order that is none
      const Outcome o =
          run(at + "$PLUMB check corpus --shard " + std::to_string(i) + "/" + std::to_string(n) + " --out " + out);
      ASSERT_EQ(o.code, 0) << o.err;
    }
    const Findings findings = found_in(folder / out);
    EXPECT_EQ(findings.size(), 23U);
    if (n == 1) first = findings;
    EXPECT_EQ(findings, first) << n;
  }
  EXPECT_EQ(verdict_of(first, "0/box0.obj"), "sound");
  EXPECT_EQ(verdict_of(first, "open.obj"), "faulty");
  EXPECT_EQ(first.at("open.obj").at("defects"), json({"open"}));
  EXPECT_EQ(verdict_of(first, "broken.stl"), "unreadable");
  EXPECT_THAT(first.at("broken.stl").at("why").get<std::string>(), HasSubstr("broken.stl"));
  // The name below the corpus decides alone: a copy elsewhere, with one model less, has the same parts.
  fs::copy(folder / "corpus", folder / "copy", fs::copy_options::recursive);
  fs::remove(folder / "copy/0/box0.obj");
  ASSERT_EQ(run(at + "$PLUMB check ./copy/ --shard 2/7 --out other").code, 0);
  for (const auto& [model, findings] : found_in(folder / "other")) {
    EXPECT_TRUE((Shard{2, 7}).holds(model)) << model;
    json was = first.at(model);
    if (was.contains("why")) continue;  // it has the file's name
    EXPECT_EQ(findings, was);
  }
}

TEST(Shards, GoOnWhereTheyWereKilled) {
  const Folder folder;
  const std::string at = with_corpus(folder, 90);
  ASSERT_EQ(run(at + "$PLUMB check corpus --shard 1/1 --out whole").code, 0);
  const Findings whole = found_in(folder / "whole");
  ASSERT_EQ(whole.size(), 93U);
  const std::string file = folder / "killed/check.1-of-1.jsonl";
  const std::string resumed = "$PLUMB check corpus --shard 1/1 --out killed";
  // A limit of the file's size stops a run in the midst of a line, however fast the machine is.
  for (const int blocks : {2, 5, 9}) {
    EXPECT_EQ(run(at + "ulimit -f " + std::to_string(blocks) + "; " + resumed).code, 2) << blocks;
    EXPECT_EQ(fs::file_size(file), 512U * blocks);
  }
  for (int attempt = 0; attempt < 40; ++attempt) {
    const Outcome o = run(at + "timeout -s KILL " + std::to_string(0.01 + 0.1 * attempt) + " " + resumed);
    if (o.code == 0) break;
    if (attempt % 2 == 0) std::ofstream(file, std::ios::app) << "{\"model\":\"0/bo";  // as if it was writing a line
  }
  const Outcome o = run(at + resumed);
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, HasSubstr("of them were there"));
  EXPECT_EQ(found_in(folder / "killed"), whole);
  const std::string before = content(file);
  EXPECT_EQ(run(at + resumed).code, 0);
  EXPECT_EQ(content(file), before);  // nothing is left to do
}

TEST(Shards, WaitForOneAnother) {
  const Folder folder;
  const std::string at = with_corpus(folder, 30);
  const std::string check = "$PLUMB check corpus --shard 1/1 --out out";
  const Outcome o = run(at + "{ " + check + " & " + check + " & wait; }");
  EXPECT_THAT(o.out, HasSubstr("33 of them were there"));
  EXPECT_EQ(found_in(folder / "out").size(), 33U);
}

TEST(Shards, OutliveTheirModels) {
  const Folder folder;
  const std::string at = with_corpus(folder, 3);
  ASSERT_EQ(::mkfifo((folder / "corpus/endless.obj").c_str(), 0600), 0);  // nobody ever writes to it
  ASSERT_EQ(run(at + "$PLUMB check corpus --shard 1/1 --out out --time-limit 3").code, 0);
  const Findings findings = found_in(folder / "out");
  EXPECT_EQ(verdict_of(findings, "endless.obj"), "timeout");
  EXPECT_EQ(verdict_of(findings, "0/box0.obj"), "sound");
  // A process that is ended from outside is as one that crashes; its parent's end is its own.
  // It is asked for once it reads what nobody writes, which needs a writer.
  const Outcome o = run(
      at +
      "exec 9<>corpus/endless.obj\n"
      "$PLUMB check corpus --shard 1/1 --out crash --time-limit 120 9>&- & shard=$!\n"
      "for i in $(seq 2000); do child=$(cat /proc/$shard/task/$shard/children 2>/dev/null); "
      "test -n \"$child\" && ls -l /proc/${child% }/fd 2>/dev/null | grep -q endless && kill -ABRT $child && break; "
      "sleep 0.02; done\nwait $shard");
  EXPECT_EQ(o.code, 0) << o.err;
  const Findings crashed = found_in(folder / "crash");
  EXPECT_EQ(verdict_of(crashed, "endless.obj"), "crashed");
  EXPECT_THAT(crashed.at("endless.obj").at("why").get<std::string>(), HasSubstr("signal 6"));
}

TEST(Shards, LimitMemory) {
  if (battery::sanitized) GTEST_SKIP() << "LimitMemory: a sanitizer's allocator does not tell that memory is over";
  const Folder folder;
  const std::string at = with_corpus(folder, 3);
  {
    std::ofstream big(folder / "corpus/big.obj");
    for (int k = 0; k < 100'000; ++k) big << "v " << k << ' ' << k % 7 << ' ' << k % 11 << '\n';
    for (int k = 1; k + 2 <= 100'000; ++k) big << "f " << k << ' ' << k + 1 << ' ' << k + 2 << '\n';
  }
  ASSERT_EQ(run(at + "$PLUMB check corpus --shard 1/1 --out out --memory-limit 8").code, 0);
  const Findings findings = found_in(folder / "out");
  EXPECT_EQ(verdict_of(findings, "big.obj"), "out_of_memory");
  EXPECT_EQ(verdict_of(findings, "0/box0.obj"), "sound");
}

TEST(Shards, RefuseWhatIsNotTheirs) {
  const Folder folder;
  const std::string at = with_corpus(folder, 3) + "$PLUMB check ";
  const auto refused = [&](const std::string& words, const std::string& why) {
    const Outcome o = run(at + words);
    EXPECT_EQ(o.code, 2) << words;
    EXPECT_THAT(o.err, HasSubstr(why)) << words;
  };
  for (const std::string part : {"0/3", "4/3", "3", "1/0", "1/2/3", "a/b", "-1/2", "1/9999999", "1 /2"})
    refused("corpus --out out --shard '" + part + "'", "--shard");
  refused("corpus --shard 1/2", "add '--out DIR'");
  refused("corpus --out out", "add '--shard 1/1'");
  refused("corpus --time-limit 1", "add '--shard 1/1'");
  refused("corpus --shard 1/1 --out out --json report.json", "exclude one another");
  refused("corpus/open.obj --shard 1/1 --out out", "name one, and no file");
  refused("--shard 1/1 --out out", "name one, and no file");
  refused("corpus --shard 1/1 --out out --time-limit 0", "--time-limit");
  EXPECT_FALSE(fs::exists(folder / "out"));
  ASSERT_EQ(run(at + "corpus --shard 1/2 --out out").code, 0);
  const std::string before = content(folder / "out/check.1-of-2.jsonl");
  refused("corpus --shard 1/3 --out out", "a shard of 2, not of 3");
  refused("corpus --shard 1/2 --out out --nearer-than 1", "with other options");
  refused("corpus/0 --shard 1/2 --out out", "another corpus");
  EXPECT_EQ(content(folder / "out/check.1-of-2.jsonl"), before);
  fs::create_directory(folder / "mine");
  for (const std::string text : {"my own notes", "my own notes\n", "{}\n"}) {
    std::ofstream(folder / "mine/check.1-of-1.jsonl") << text;
    refused("corpus --shard 1/1 --out mine", "check.1-of-1.jsonl");
    EXPECT_EQ(content(folder / "mine/check.1-of-1.jsonl"), text);
  }
  refused("corpus --shard 1/1 --out mine/check.1-of-1.jsonl/under", "cannot be made");
}

TEST(LimitedProcess, TellsHowItsWorkEnded) {
  const ProcessEnd good = run_limited({}, [] { return std::string(100'000, 'x'); });
  EXPECT_EQ(good.how, HowEnded::done);
  EXPECT_EQ(good.text, std::string(100'000, 'x'));
  const ProcessEnd thrown = run_limited({}, []() -> std::string { throw std::runtime_error("a reason"); });
  EXPECT_EQ(thrown.how, HowEnded::crashed);
  EXPECT_THAT(thrown.why, HasSubstr("a reason"));
  const ProcessEnd memory = run_limited({}, []() -> std::string { throw std::bad_alloc(); });
  EXPECT_EQ(memory.how, HowEnded::out_of_memory);
  const ProcessEnd aborted = run_limited({}, []() -> std::string {
    std::signal(SIGABRT, SIG_DFL);
    ::raise(SIGABRT);
    return "";
  });
  EXPECT_EQ(aborted.how, HowEnded::crashed);
  EXPECT_THAT(aborted.why, HasSubstr("signal 6"));
  const ProcessEnd slow = run_limited({.seconds = 0.05, .mib = {}}, []() -> std::string {
    while (true) ::pause();
  });
  EXPECT_EQ(slow.how, HowEnded::timeout);
  EXPECT_LT(slow.seconds, 10);
  const ProcessEnd quick = run_limited({.seconds = 1e9, .mib = {}}, [] { return std::string("in time"); });
  EXPECT_EQ(quick.text, "in time");
}

}  // namespace
}  // namespace plumb::tool
