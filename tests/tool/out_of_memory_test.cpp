// Whatever memory there is, and whether or not threads can be made: each command that writes, of either program, does its
// work, or ends with 2, names the file that it could not read, or all its words, and leaves everything as it was.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "certify/forbidden_threads.hpp"
#include "certify/sanitized.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::AnyOf;
using testing::StartsWith;
using testing::Truly;

constexpr std::uint64_t unlimited = 0;

struct Ended {
  int status = 0;  // as waitpid tells it
  std::string err;

  [[nodiscard]] int code() const { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }
};

enum class Program : bool { plumb, laboratory };

std::string path_of(Program program) { return program == Program::plumb ? tested_program() : tested_laboratory(); }

/// In this folder, with so much address space.
Ended run(Program program, const std::vector<std::string>& words, const std::string& folder, std::uint64_t kib,
          std::optional<Forbidden> threads = std::nullopt) {
  const std::string err = folder + "/err";
  std::vector<std::string> all{path_of(program)};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (std::string& word : all) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = ::fork();
  if (child == 0) {
    if (::chdir(folder.c_str()) != 0) ::_exit(99);
    ::dup2(::open("/dev/null", O_RDWR), STDOUT_FILENO);
    ::dup2(::open(err.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), STDERR_FILENO);
    if (threads && !forbid_threads(*threads)) ::_exit(98);
    const rlimit no_core{0, 0};
    ::setrlimit(RLIMIT_CORE, &no_core);
    if (kib != unlimited) {
      const rlimit most{kib << 10, kib << 10};
      ::setrlimit(RLIMIT_AS, &most);
    }
    ::execv(all[0].c_str(), arguments.data());
    ::_exit(97);
  }
  Ended ended;
  ::waitpid(child, &ended.status, 0);
  ended.err = content(err);
  return ended;
}

/// A command that writes, and the outputs it is asked for.
struct Writer {
  std::string name;  // of the test
  std::vector<std::string> words;
  std::vector<std::string> outputs;  // files, also those in a folder
  Program program = Program::plumb;
  bool is_hungry = true;  // takes more memory than the program does to begin
  bool replaces = true;   // an output that is there
  std::string list = {};  // where the folder of a report tells its own files
  bool is_long = false;   // takes seconds, and is run at fewer sizes
};

void PrintTo(const Writer& writer, std::ostream* out) { *out << writer.name; }

constexpr Program laboratory = Program::laboratory;

/// Those of `plumb fuzz`; a corpus has no file of a known name.
const std::vector<std::string> of_fuzz{
    "fuzz",     "--kind",         "orient3d",    "--library", PLUMB_FOREIGN "/wrong.so",
    "--symbol", "naive_orient3d", "--generator", "near_half", "--cases",
    "300",      "--corpus",       "corpus"};

std::vector<std::string> with(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

const std::vector<Writer> writers{
    {"pairs",
     {"pairs", "boxes.csv", "--json", "a.json", "--out", "a.npy", "--svg", "a.svg", "--overwrite"},
     {"a.json", "a.npy", "a.svg"}},
    {"nearest",
     {"nearest", "points.csv", "queries.csv", "--json", "a.json", "--out", "a.npy", "--distances", "b.npy", "--svg",
      "a.svg", "--overwrite"},
     {"a.json", "a.npy", "b.npy", "a.svg"}},
    {"check", {"check", "part.obj", "--json", "a.json", "--chart", "a.svg"}, {"a.json", "a.svg"}},
    {.name = "sample",
     .words = {"check", "--write-sample", "a.obj"},
     .outputs = {"a.obj"},
     .is_hungry = false,
     .replaces = false},
    {"plan", {"plan", "small.obj", "--json", "a.json", "--chart", "a.svg"}, {"a.json", "a.svg"}},
    {.name = "bounds",
     .words = {"bounds", "small.obj", "--json", "a.json", "--chart", "a.svg"},
     .outputs = {"a.json", "a.svg"},
     .is_hungry = false},
    {"bvh",
     {"bvh", "part.obj", "--json", "a.json", "--svg", "a.svg", "--out", "a.bvh", "--overwrite"},
     {"a.json", "a.svg", "a.bvh"}},
    {.name = "bsp", .words = {"bsp", "block.obj", "--json", "a.json"}, .outputs = {"a.json"}, .is_hungry = false},
    {.name = "section",
     .words = {"section", "part.obj", "--plane", "z=0.3", "--json", "a.json", "--svg", "a.svg", "--dxf", "a.dxf",
               "--out", "report"},
     .outputs = {"a.json", "a.svg", "a.dxf", "report/section-0001.svg"},
     .is_hungry = false,
     .list = "report/.plumb-section-files"},
    {"distance",
     {"distance", "part.obj", "far.obj", "--json", "a.json", "--obj", "a.obj", "--overwrite"},
     {"a.json", "a.obj"}},
    {"intersect",
     {"intersect", "part.obj", "near.obj", "--json", "a.json", "--obj", "a.obj", "--overwrite"},
     {"a.json", "a.obj"}},
    {.name = "convex",
     .words = {"convex", "part.obj", "far.obj", "--json", "a.json", "--certificate", "b.json", "--history", "report"},
     .outputs = {"a.json", "b.json", "report/index.html"},
     .list = "report/.plumb-convex-files"},
    {"closest",
     {"closest", "part.obj", "points.csv", "--json", "a.json", "--obj", "a.obj", "--overwrite"},
     {"a.json", "a.obj"}},
    {"hausdorff",
     {"hausdorff", "part.obj", "far.obj", "--json", "a.json", "--obj", "a.obj", "--overwrite"},
     {"a.json", "a.obj"}},
    {.name = "clash",
     .words = {"clash", "block.obj", "small.obj", "--json", "a.json", "--csv", "a.csv", "--bcf", "a.bcf", "--page",
               "a.html", "--overwrite"},
     .outputs = {"a.json", "a.csv", "a.bcf", "a.html"},
     .is_hungry = false},
    {.name = "collect",
     .words = {"collect", ".", "--json", "a.json", "--csv", "a.csv", "--page", "a.html"},
     .outputs = {"a.json", "a.csv", "a.html"},
     .is_hungry = false},
    {.name = "boolean",
     .words = {"boolean", "union", "block.obj", "small.obj", "--output", "a.obj", "--json", "a.json", "--overwrite"},
     .outputs = {"a.obj", "a.json"}},
    {.name = "resolve",
     .words = {"resolve", "small.obj", "--output", "a.obj", "--json", "a.json", "--overwrite"},
     .outputs = {"a.obj", "a.json"}},
    {.name = "split",
     .words = {"split", "small.obj", "--plane", "z=0.1", "--output", "a.obj", "--other", "b.obj", "--json", "a.json",
               "--overwrite"},
     .outputs = {"a.obj", "b.obj", "a.json"}},
    {.name = "csg",
     .words = {"csg", "model.csg", "--output", "a.obj", "--json", "a.json", "--overwrite"},
     .outputs = {"a.obj", "a.json"}},
    {.name = "parts",
     .words = {"parts", "block.obj", "--json", "a.json", "--obj", "a.obj", "--overwrite"},
     .outputs = {"a.json", "a.obj"},
     .is_hungry = false},
    {"inside", {"inside", "part.obj", "--points", "points.csv", "--json", "a.json"}, {"a.json"}},
    {"ray",
     {"ray", "part.obj", "--ray", "-9,0.1,0.2,1,0,0", "--json", "a.json", "--obj", "a.obj", "--overwrite"},
     {"a.json", "a.obj"}},
    {"convert", {"convert", "part.obj", "a.stl", "--overwrite"}, {"a.stl"}},
    {"repair",
     {"repair", "part.obj", "--output", "a.ply", "--json", "a.json", "--page", "a.html", "--overwrite"},
     {"a.ply", "a.json", "a.html"}},
    {.name = "replay",
     .words = {"replay", "questions.txt", "--out", "a.txt", "--json", "a.json", "--page", "a.html", "--overwrite"},
     .outputs = {"a.txt", "a.json"}},
    {.name = "proof", .words = {"proof", "orient2d", "--out", "a.g"}, .outputs = {"a.g"}, .is_hungry = false},
    {.name = "fuzz",
     .words = with(of_fuzz, {"--out", "report"}),
     .outputs = {"report/fuzz.txt", "report/fuzz.json", "report/fuzz.svg", "report/fuzz.html", "report/case-1.py"},
     .list = "report/.plumb-fuzz-files"},
    {.name = "corpus", .words = of_fuzz, .outputs = {}},
    {.name = "pages",
     .words = {"help", "--write-pages", "share"},
     .outputs = {"share/man/man1/plumb.1", "share/zsh/site-functions/_plumb"},
     .is_hungry = false},
    {.name = "lab_pages",
     .words = {"help", "--write-pages", "share"},
     .outputs = {"share/man/man1/plumb-lab.1", "share/man/man1/plumb-lab-chart.1"},
     .program = laboratory,
     .is_hungry = false},
    {.name = "chart",
     .words = {"chart", "--quick", "--task", "closest-hit", "--class", "turned", "--out", "report"},
     .outputs = {"report/chart.txt", "report/chart.json", "report/chart.html", "report/closest-hit-turned.svg"},
     .program = laboratory,
     .list = "report/.plumb-chart-files"},
    {.name = "stability",
     .words = {"stability", "--quick", "--experiment", "posed-contacts", "--experiment", "moved-scenes", "--out",
               "report"},
     .outputs = {"report/stability.txt", "report/stability.json", "report/stability.html", "report/scene-turned.svg"},
     .program = laboratory,
     .list = "report/.plumb-stability-files"},
    {.name = "vectors",
     .words = {"vectors", "--out", "report"},
     .outputs = {"report/orient2d.txt", "report/convex-distance.txt", "report/hull-of-any-size.txt"},
     .program = laboratory,
     .list = "report/.plumb-vectors-files",
     .is_long = true},
};

void write_inputs(const std::string& folder) {
  std::uint64_t state = 1;
  const auto random = [&] {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 40) / double(1 << 24);
  };
  std::ofstream boxes(folder + "/boxes.csv"), points(folder + "/points.csv"), queries(folder + "/queries.csv");
  for (int i = 0; i < 8000; ++i) {
    const double x = random(), y = random(), z = random();
    boxes << x << ',' << y << ',' << z << ',' << x + 0.1 << ',' << y + 0.1 << ',' << z + 0.1 << '\n';
    points << x << ',' << y << ',' << z << '\n';
    queries << y << ',' << z << ',' << x << '\n';
  }
  std::ofstream questions(folder + "/questions.txt");
  for (int i = 0; i < 20000; ++i) questions << "distance | point3 0 0 0 | ball3 " << i << " 0 0 1\n";
  std::ofstream(folder + "/model.csg") << "difference() { import(\"small.obj\"); import(\"block.obj\"); }\n";
  std::ofstream shard(folder + "/check.1-of-1.jsonl");
  shard << R"({"command":"check","corpus":"parts","settings":{},"shard":1,"shards":1})" << '\n';
  for (int i = 0; i < 2000; ++i)
    shard << R"({"defects":["open"],"faults":{"open edges":3},"model":")" << i << R"(.obj","verdict":"faulty"})"
          << '\n';
  shard << "{\"done\":2000}\n";
  std::ofstream(folder + "/block.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  for (const auto& [name, at, n] :
       {std::tuple("part", 0.0, 80), {"near", 0.4, 80}, {"far", 7.0, 80}, {"small", 0.0, 24}}) {
    std::ofstream mesh(folder + "/" + name + ".obj");
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < n; ++k) {
        const double u = 6.283185307179586 * i / n, v = 6.283185307179586 * k / n, r = 2 + std::cos(v) * 0.7;
        mesh << "v " << at + r * std::cos(u) << ' ' << r * std::sin(u) << ' ' << 0.7 * std::sin(v) << '\n';
      }
    }
    const auto number = [n = n](int i, int k) { return i % n * n + k % n + 1; };  // of a ring
    for (int i = 0; i < n; ++i) {
      for (int k = 0; k < n; ++k) {
        mesh << "f " << number(i, k) << ' ' << number(i + 1, k) << ' ' << number(i + 1, k + 1) << ' '
             << number(i, k + 1) << '\n';
      }
    }
  }
}

void write_old(const Writer& writer, const std::string& folder) {
  for (const std::string& output : writer.outputs) {
    fs::create_directories(fs::path(folder + "/" + output).parent_path());
    std::ofstream(folder + "/" + output) << "old";
    if (!writer.list.empty())
      std::ofstream(folder + "/" + writer.list, std::ios::app) << fs::path(output).filename().string() << '\n';
  }
}

using Contents =
    std::map<std::string, std::string>;  // of every file, or its size where that is large; of a folder, nothing

Contents everything_in(const std::string& folder) {
  Contents all;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string path = entry.path().string();
    if (entry.path().filename() == "err") continue;
    const std::uintmax_t size = entry.is_directory() ? 0 : entry.file_size();
    all[path] = size > 1 << 16 ? std::to_string(size) : size > 0 ? content(path) : "";
  }
  return all;
}

/// A file that it reads or writes, or all of its words.
auto names_what(const Writer& writer) {
  std::string all = "out of memory: " + fs::path(path_of(writer.program)).filename().string();
  std::vector<std::string> files = writer.outputs;
  for (const std::string& word : writer.words) {
    all += " " + word;
    if (word != writer.words[0] && word.size() > 3 && !word.starts_with("-")) files.push_back(word);
  }
  return Truly([all, files](const std::string& err) {
    const auto has = [&](const std::string& text) { return err.find(text) != std::string::npos; };
    return has(all) || std::ranges::any_of(files, has);
  });
}

/// 0, or 1 where the command's answer is no: the outputs are new; 2: nothing is, and the words say why.
void expect_sound_end(const Writer& writer, const std::string& folder, const Contents& before, const Ended& ended) {
  ASSERT_THAT(ended.code(), AnyOf(0, 1, 2)) << ended.err;
  const Contents after = everything_in(folder);
  for (const auto& [path, text] : after) EXPECT_FALSE(path.ends_with(".part")) << path;
  if (ended.code() == 2) {
    EXPECT_TRUE(after == before) << ended.err;
    const std::string program = writer.program == Program::plumb ? "plumb: " : "plumb-lab: ";
    EXPECT_THAT(ended.err, AllOf(StartsWith(program), names_what(writer))) << ended.err;
    return;
  }
  EXPECT_GT(after.size(), before.size() - 1);
  for (const std::string& output : writer.outputs) {
    const auto at = after.find(folder + "/" + output);
    ASSERT_TRUE(at != after.end()) << output;
    EXPECT_FALSE(at->second == "old" || at->second.empty()) << output;
  }
}

/// The least at which the program gets as far as its first line, KiB: below it the system's loader complains.
std::uint64_t floor_of(Program program, const std::string& folder) {
  std::uint64_t low = 1 << 10, high = 1 << 20;
  while (high - low > 256) {
    const std::uint64_t middle = (low + high) / 2;
    (run(program, {"--version"}, folder, middle).code() == 0 ? high : low) = middle;
  }
  return high;
}

class OutOfMemory : public testing::TestWithParam<Writer> {};

TEST_P(OutOfMemory, EndsWith2AndLeavesWhatWas) {
  if (battery::sanitized) GTEST_SKIP() << "sanitizers need all the address space there is";
  const Writer& writer = GetParam();
  if (path_of(writer.program).empty()) GTEST_SKIP() << "no laboratory was built";
  const Folder inputs;
  write_inputs(inputs / ".");
  const auto floor = static_cast<std::ptrdiff_t>(floor_of(writer.program, inputs / "."));
  int done = 0, refused = 0;
  // From what suffices down to the floor, by steps that grow with what is above it.
  for (std::ptrdiff_t above = writer.is_long ? 1 << 14 : 1 << 19; above > 64;
       above = above * (writer.is_long ? 2 : 6) / 10) {
    const Folder folder;
    const std::string place = folder / "place";
    fs::copy(inputs / ".", place);
    if (writer.replaces && (done + refused) % 3 != 2) write_old(writer, place);
    const Contents before = everything_in(place);
    SCOPED_TRACE(std::to_string(floor + above) + " KiB");
    const Ended ended = run(writer.program, writer.words, place, static_cast<std::uint64_t>(floor + above));
    expect_sound_end(writer, place, before, ended);
    if (HasFatalFailure()) return;
    (ended.code() == 2 ? refused : done) += 1;
  }
  EXPECT_GT(done, 0);
  EXPECT_TRUE(refused > 0 || !writer.is_hungry);
}

TEST_P(OutOfMemory, DoesItsWorkOnOneThreadWhereNoneCanBeMade) {
  if (battery::sanitized) GTEST_SKIP() << "sanitizers make threads of their own";
  const Writer& writer = GetParam();
  if (path_of(writer.program).empty()) GTEST_SKIP() << "no laboratory was built";
  const Folder folder;
  const std::string place = folder / ".";
  write_inputs(place);
  const Contents before = everything_in(place);
  const Ended ended = run(writer.program, writer.words, place, unlimited, Forbidden::refused);
  EXPECT_THAT(ended.code(), AnyOf(0, 1)) << ended.err;
  EXPECT_EQ(ended.err, "");
  expect_sound_end(writer, place, before, ended);
}

// To make one would be the end of it.
TEST(OneThread, IsAllThatOneThreadTakes) {
  if (battery::sanitized) GTEST_SKIP() << "sanitizers make threads of their own";
  const Folder folder;
  const std::string place = folder / ".";
  write_inputs(place);
  const auto code = [&](const std::vector<std::string>& words) {
    return run(Program::plumb, words, place, unlimited, Forbidden::deadly).code();
  };
  EXPECT_EQ(code({"check", "part.obj", "--threads", "1"}), 0);
  EXPECT_EQ(code({"nearest", "points.csv", "queries.csv", "--threads", "1"}), 0);
  EXPECT_EQ(code({"pairs", "boxes.csv", "--threads", "1"}), 0);
  EXPECT_EQ(code({"check", "part.obj", "--threads", "2"}), 128 + SIGSYS);
}

// Whatever option names a file or a folder, names one to write or is told here to read it.
TEST(Writers, AreAllThereAre) {
  const std::set<std::string> read{"--ccd",    "--judge", "--library",  "--models",
                                   "--points", "--rays",  "--segments", "--tree"};
  for (const auto& [program, name] : {std::pair(Program::plumb, "$PLUMB"), {laboratory, "$PLUMB_LAB"}}) {
    if (path_of(program).empty()) continue;
    for (const std::string& command : commands(name)) {
      const std::string page = tool::run(std::string(name) + " help " + command).out;
      const std::regex option(R"((--[a-z-]+)(\[=|=|\[| )+(FILE|DIR)\b)");
      for (std::sregex_iterator at(page.begin(), page.end(), option), end; at != end; ++at) {
        const std::string word = (*at)[1];
        const auto writes = [&, &program = program](const Writer& w) {
          return w.program == program && w.words[0] == command && std::ranges::count(w.words, word) > 0;
        };
        const bool is_of_shards = (command == "check" || command == "clash" || command == "repair") &&
                                  word == "--out";  // whose lines stay (shard_cli_test.cpp)
        EXPECT_TRUE(read.contains(word) || is_of_shards || std::ranges::any_of(writers, writes))
            << name << ' ' << command << ' ' << word;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Commands, OutOfMemory, testing::ValuesIn(writers),
                         [](const auto& writer) { return writer.param.name; });

}  // namespace
}  // namespace plumb::tool
