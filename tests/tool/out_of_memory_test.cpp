// Whatever memory there is, and whether or not threads can be made: a command does its work, or ends with 2, says that
// memory is lacking or which file it could not read, and leaves the outputs of before as they were.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "certify/forbidden_threads.hpp"
#include "certify/sanitized.hpp"
#include "tool/run_program.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::HasSubstr;

constexpr std::uint64_t unlimited = 0;

struct Ended {
  int status = 0;  // as waitpid tells it
  std::string err;

  [[nodiscard]] int code() const { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }
};

/// In this folder, with so much address space.
Ended run(const std::vector<std::string>& words, const std::string& folder, std::uint64_t kib,
          std::optional<Forbidden> threads = std::nullopt) {
  const std::string err = folder + "/err";
  std::vector<std::string> all{tested_program()};
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
  std::vector<std::string> words;
  std::vector<std::string> outputs;
  bool is_hungry = true;  // takes more memory than the program does to begin
};

const std::vector<Writer> writers{
    {{"pairs", "boxes.csv", "--json", "a.json", "--out", "a.npy", "--svg", "a.svg", "--overwrite"},
     {"a.json", "a.npy", "a.svg"}},
    {{"nearest", "points.csv", "queries.csv", "--json", "a.json", "--out", "a.npy", "--distances", "b.npy", "--svg",
      "a.svg", "--overwrite"},
     {"a.json", "a.npy", "b.npy", "a.svg"}},
    {{"check", "part.obj", "--json", "a.json", "--chart", "a.svg"}, {"a.json", "a.svg"}},
    {{"plan", "small.obj", "--json", "a.json", "--chart", "a.svg"}, {"a.json", "a.svg"}},
    {{"bounds", "small.obj", "--json", "a.json", "--chart", "a.svg"}, {"a.json", "a.svg"}, false},
    {{"bvh", "part.obj", "--json", "a.json", "--svg", "a.svg", "--overwrite"}, {"a.json", "a.svg"}},
    {{"section", "part.obj", "--plane", "z=0.3", "--json", "a.json", "--svg", "a.svg", "--dxf", "a.dxf"},
     {"a.json", "a.svg", "a.dxf"},
     false},
    {{"distance", "part.obj", "far.obj", "--json", "a.json"}, {"a.json"}},
    {{"intersect", "part.obj", "near.obj", "--json", "a.json"}, {"a.json"}},
    {{"convex", "part.obj", "far.obj", "--json", "a.json", "--certificate", "b.json"}, {"a.json", "b.json"}},
    {{"inside", "part.obj", "--points", "points.csv", "--json", "a.json"}, {"a.json"}},
    {{"ray", "part.obj", "--ray", "-9,0.1,0.2,1,0,0", "--json", "a.json"}, {"a.json"}},
    {{"convert", "part.obj", "a.stl", "--overwrite"}, {"a.stl"}},
    {{"proof", "orient2d", "--out", "a.g"}, {"a.g"}, false},
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
  for (const std::string& output : writer.outputs) std::ofstream(folder + "/" + output) << "old";
}

/// 0, or 1 where the command's answer is no: the outputs are new; 2: they are old, and the words say why.
void expect_sound_end(const Writer& writer, const std::string& folder, const Ended& ended) {
  ASSERT_THAT(ended.code(), AnyOf(0, 1, 2)) << ended.err;
  for (const std::string& output : writer.outputs)
    EXPECT_EQ(content(folder + "/" + output) == "old", ended.code() == 2) << output << ": " << ended.err;
  if (ended.code() != 2) return;
  EXPECT_THAT(ended.err, AnyOf(HasSubstr("memory"), HasSubstr(writer.words[1]))) << ended.err;
}

/// The least at which the program gets as far as its first line, KiB: below it the system's loader complains.
std::uint64_t floor_of_program(const std::string& folder) {
  std::uint64_t low = 1 << 10, high = 1 << 20;
  while (high - low > 256) {
    const std::uint64_t middle = (low + high) / 2;
    (run({"--version"}, folder, middle).code() == 0 ? high : low) = middle;
  }
  return high;
}

class OutOfMemory : public testing::TestWithParam<Writer> {};

TEST_P(OutOfMemory, EndsWith2AndLeavesWhatWas) {
  if (battery::sanitized) GTEST_SKIP() << "sanitizers need all the address space there is";
  const Writer& writer = GetParam();
  const Folder folder;
  const std::string place = folder / ".";
  write_inputs(place);
  const std::ptrdiff_t floor = static_cast<std::ptrdiff_t>(floor_of_program(place));
  int done = 0, refused = 0;
  // From what suffices down to the floor, by steps that grow with what is above it.
  for (std::ptrdiff_t above = 1 << 19; above > 64; above = above * 6 / 10) {
    write_old(writer, place);
    SCOPED_TRACE(std::to_string(floor + above) + " KiB");
    const Ended ended = run(writer.words, place, static_cast<std::uint64_t>(floor + above));
    expect_sound_end(writer, place, ended);
    if (HasFatalFailure()) return;
    (ended.code() == 2 ? refused : done) += 1;
    for (const auto& entry : fs::directory_iterator(place)) EXPECT_NE(entry.path().extension(), ".part");
  }
  EXPECT_GT(done, 0);
  EXPECT_TRUE(refused > 0 || !writer.is_hungry);
}

TEST_P(OutOfMemory, DoesItsWorkOnOneThreadWhereNoneCanBeMade) {
  if (battery::sanitized) GTEST_SKIP() << "sanitizers make threads of their own";
  const Writer& writer = GetParam();
  const Folder folder;
  const std::string place = folder / ".";
  write_inputs(place);
  write_old(writer, place);
  const Ended ended = run(writer.words, place, unlimited, Forbidden::refused);
  EXPECT_THAT(ended.code(), AnyOf(0, 1)) << ended.err;
  EXPECT_EQ(ended.err, "");
  expect_sound_end(writer, place, ended);
}

// To make one would be the end of it.
TEST(OneThread, IsAllThatOneThreadTakes) {
  if (battery::sanitized) GTEST_SKIP() << "sanitizers make threads of their own";
  const Folder folder;
  const std::string place = folder / ".";
  write_inputs(place);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"check", "part.obj", "--threads", "1"},
        std::vector<std::string>{"nearest", "points.csv", "queries.csv", "--threads", "1"},
        std::vector<std::string>{"pairs", "boxes.csv", "--threads", "1"}}) {
    EXPECT_EQ(run(words, place, unlimited, Forbidden::deadly).code(), 0) << words[0];
  }
  EXPECT_EQ(run({"check", "part.obj", "--threads", "2"}, place, unlimited, Forbidden::deadly).code(), 128 + SIGSYS);
}

INSTANTIATE_TEST_SUITE_P(Commands, OutOfMemory, testing::ValuesIn(writers),
                         [](const auto& writer) { return writer.param.words[0]; });

}  // namespace
}  // namespace plumb::tool
