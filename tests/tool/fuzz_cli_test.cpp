// `plumb fuzz` as a user meets it: faulty functions are found, right ones are not, and no foreign code spoils the run.
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tool/fuzz_commands.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;

using testing::AnyOf;

TEST(Fuzz, FindsWhereFloatingPointIsWrongAndAsksItAgain) {
  const Outcome o = run(command("wrong", "naive_orient3d") + "--cases 60" + kFewGenerators);
  EXPECT_EQ(o.code, 1);
  EXPECT_EQ(o.err, "");
  EXPECT_THAT(o.out, Not(HasSubstr("\033")));
  EXPECT_THAT(line_of(o.out, "  uniform"), HasSubstr(" 0 %"));
  EXPECT_THAT(line_of(o.out, "  degenerate_long"), Not(HasSubstr(" 0 %")));
  const std::vector<std::string> lines = replay_lines(o.out);
  ASSERT_FALSE(lines.empty());
  for (const std::string& line : lines) {
    const Outcome again = run(line);
    EXPECT_EQ(again.code, 1) << line;
    const std::string verdict = line_of("\n" + again.out, "given ");
    ASSERT_NE(verdict, "");
    EXPECT_THAT(o.out, HasSubstr("\n" + verdict.substr(0, verdict.find(": ")) + "\n"));
  }
  EXPECT_EQ(run(command("right", "right_orient3d") + lines[0].substr(lines[0].find("--case"))).code, 0);
}

TEST(Fuzz, FindsAnEpsilonBetweenTriangles) {
  const Outcome o =
      run(command("wrong", "epsilon_triangles", "triangle-triangle") + "--cases 30 --format cpp --generator near_half");
  EXPECT_EQ(o.code, 1) << o.err;
  EXPECT_THAT(o.out, AllOf(HasSubstr("given yes, exact no"), HasSubstr("TEST("), HasSubstr("epsilon_triangles(")));
}

TEST(Fuzz, AsksFunctionsOfMeshesAndShrinksThese) {
  const Outcome o = run(command("wrong", "leaking_ray_mesh", "ray-mesh") + "--cases 20 --format obj --generator box");
  EXPECT_EQ(o.code, 1) << o.err;
  EXPECT_EQ(line_of(o.out, "triangles = "), "triangles = (0, 1, 2)");
  EXPECT_THAT(o.out, AllOf(HasSubstr("no for yes"), HasSubstr("\no vertices\nv "), HasSubstr("\nf 3 ")));
  ASSERT_FALSE(replay_lines(o.out).empty());
  EXPECT_EQ(run(replay_lines(o.out)[0]).code, 1);
  // Every argument ends where readable memory ends, not the last alone.
  const Outcome greedy = run(command("wrong", "greedy_ray_mesh", "ray-mesh") + "--cases 2 --generator box");
  EXPECT_EQ(greedy.code, 1) << greedy.err;
  EXPECT_THAT(greedy.out, HasSubstr("given crashed (SIGSEGV), exact "));
}

TEST(Fuzz, FindsNothingWhereNothingIsWrong) {
  const Outcome o = run(command("right", "right_orient3d") + "--cases 500");
  EXPECT_EQ(o.code, 0) << o.out << o.err;
  EXPECT_EQ(o.err, "");
  EXPECT_THAT(o.out, AllOf(HasSubstr("nothing found"), Not(HasSubstr("--case"))));
}

TEST(Fuzz, SurvivesWhatForeignCodeDoesAndReportsIt) {
  struct Case {
    std::string module, symbol, words;
  };
  for (const Case& c : {Case{"wrong", "crashing_orient3d", "crashed (SIGABRT)"},
                        Case{"wrong", "hanging_orient3d", "hung (longer than 20 ms)"},
                        Case{"wrong", "leaving_orient3d", "exited (with code 3)"},
                        Case{"wrong", "greedy_orient3d", "crashed (SIGSEGV)"},
                        Case{"throws", "throwing_orient3d", "threw (four points of one height)"}}) {
    // Only what never returns is not given time: to leave takes some, where leaks are looked for.
    const std::string limit = c.symbol == "hanging_orient3d" ? "--timeout 0.02 " : "";
    const Outcome o = run(command(c.module, c.symbol) + "--cases 30 " + limit + "--generator repeated");
    EXPECT_EQ(o.code, 1) << c.symbol << o.err;
    EXPECT_THAT(o.out, HasSubstr("given " + c.words + ", exact ")) << c.symbol;
    const std::vector<std::string> lines = replay_lines(o.out);
    ASSERT_FALSE(lines.empty()) << c.symbol;
    bool again = false;
    for (const std::string& line : lines) again |= run(line).out.find("given " + c.words) != std::string::npos;
    EXPECT_TRUE(again) << c.symbol;
  }
}

TEST(Fuzz, ShrinksCrashesToTheSimplestThatCrashes) {
  const Outcome o = run(command("wrong", "crashing_orient3d") + "--cases 30 --generator repeated");
  // All points in the origin: nothing is simpler that has two equal ones.
  EXPECT_THAT(o.out, HasSubstr("--case 'orient3d 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 "));
}

TEST(Fuzz, KeepsForeignOutputOutOfTheReport) {
  const Outcome o = run(command("wrong", "talking_orient3d") + "--cases 50" + kFewGenerators);
  EXPECT_EQ(o.code, 1);
  EXPECT_EQ(o.err, "");
  EXPECT_THAT(o.out, Not(AnyOf(HasSubstr("was asked"), HasSubstr("complains"))));
}

TEST(Fuzz, GoesOnWhereItsOwnFilesAreClosed) {
  const Outcome o = run(command("wrong", "closing_orient3d") + "--generator uniform --cases 600");
  EXPECT_EQ(o.code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("nothing found in 600 cases"));
}

TEST(Fuzz, GoesOnWhereStandardStreamsAreClosed) {
  for (const char* closed : {" <&-", " 2>&-", " <&- 2>&-"}) {
    const Outcome o = run(command("right", "right_orient3d") + "--generator uniform --cases 600" + closed);
    EXPECT_EQ(o.code, 0) << o.out << o.err;
    EXPECT_THAT(o.out, HasSubstr("nothing found in 600 cases"));
  }
}

TEST(Fuzz, HearsNoAnswersOfProcessesThatTheFunctionForked) {
  const Outcome o = run(command("wrong", "forking_orient3d") + "--generator uniform --cases 600");
  EXPECT_EQ(o.code, 0) << o.out << o.err;
  EXPECT_THAT(o.out, HasSubstr("nothing found in 600 cases"));
}

TEST(Fuzz, ReportsTheSameForTheSameSeed) {
  const std::string line = command("wrong", "naive_orient3d") + "--cases 60" + kFewGenerators;
  const std::string first = run(line).out;
  EXPECT_EQ(run(line + "--seed 2026").out, first);
  EXPECT_NE(run(line + "--seed 7").out, first);
}

TEST(Fuzz, StopsWhenTimeIsUpOrTheUserSaysSo) {
  EXPECT_THAT(run(command("right", "right_orient3d") + "--time 0.2").out, HasSubstr("nothing found"));
  // Also in the middle of a block, where each call takes a fiftieth of a second.
  const std::string slow = run(command("wrong", "slow_orient3d") + "--time 0.2 --generator uniform").out;
  const std::size_t at = slow.find("nothing found in ");
  ASSERT_NE(at, std::string::npos) << slow;
  EXPECT_LE(std::stoi(slow.substr(at + 17)), 12);
  const Outcome o =
      run("timeout --preserve-status -s INT 0.4 " + command("wrong", "naive_orient3d") + "--time 1e9" + kFewGenerators);
  EXPECT_EQ(o.code, 1) << o.err;
  EXPECT_THAT(o.out, AllOf(HasSubstr("interrupted"), HasSubstr("--case")));
}

TEST(Fuzz, TellsATerminalWhichCallHangs) {
  if (!has_terminals()) return;
  const Outcome o =
      run_on_terminal(command("wrong", "hanging_orient3d") + "--cases 3 --timeout 0.9 --generator repeated");
  EXPECT_EQ(o.code, 1) << o.out;
  // Which case it is and since when, again and again while nothing comes back; and how many have not.
  EXPECT_THAT(o.out, testing::ContainsRegex("fuzz: repeated [0-9]+ for 0\\.[345] s"));
  EXPECT_THAT(o.out, testing::ContainsRegex("fuzz: repeated [0-9]+ for 0\\.[678] s"));
  EXPECT_THAT(o.out, testing::ContainsRegex("; [1-9] hung"));
  EXPECT_THAT(o.out, testing::ContainsRegex("fuzz: making hung of repeated simple"));
  EXPECT_THAT(run(command("wrong", "hanging_orient3d") + "--cases 1 --timeout 0.4 --generator repeated").err, "");
}

TEST(FuzzCorpus, GrowsAndIsAskedFirst) {
  const Folder folder;
  const std::string line =
      command("wrong", "naive_orient3d") + "--cases 60" + kFewGenerators + "--corpus " + (folder / "c");
  const Outcome first = run(line);
  EXPECT_THAT(first.out, Not(HasSubstr("  corpus ")));
  const auto files = std::distance(fs::directory_iterator(folder / "c"), {});
  EXPECT_GT(files, 0);
  EXPECT_THAT(first.out, HasSubstr(std::to_string(files) + " new in "));
  std::ofstream(folder / "c/others.txt") << "# a comment\n\norient2d 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x1p+0\n";
  const Outcome second = run(command("right", "right_orient3d") + "--cases 1 --corpus " + (folder / "c"));
  EXPECT_EQ(second.code, 0);
  EXPECT_THAT(line_of(second.out, "  corpus "), HasSubstr(" " + std::to_string(files) + " "));
  const Outcome third =
      run(command("wrong", "naive_orient3d") + "--cases 1 --generator uniform --corpus " + (folder / "c"));
  EXPECT_EQ(third.code, 1);
  EXPECT_THAT(line_of(third.out, "  corpus "), HasSubstr("100 %"));
}

TEST(FuzzCorpus, PassesOverWhatIsNoFileAndWhatOthersAreWriting) {
  const Folder folder;
  fs::create_directories(folder / "c/deeper");
  ASSERT_EQ(::mkfifo((folder / "c/pipe").c_str(), 0600), 0);
  std::ofstream(folder / "c/.orient3d-0.case.1.part") << "orient3d 0x";
  const Outcome o = run(command("right", "right_orient3d") + "--cases 1 --corpus " + (folder / "c"));
  EXPECT_EQ(o.code, 0) << o.err;
}

TEST(FuzzCorpus, IsRefusedWhereItHoldsNoCases) {
  for (const std::string text : {"orient3d 1 2 3\n", "hello\n", "orient3d 0 0 0 0 0 0 0 0 0 0 0 nan\n"}) {
    const Folder folder;
    fs::create_directory(folder / "c");
    std::ofstream(folder / "c/odd.txt") << "# fine\n" << text;
    const Outcome o = run(command("wrong", "naive_orient3d") + "--corpus " + (folder / "c"));
    expect_refusal(o, "odd.txt:2: ");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "c"), {}), 1);
  }
}

TEST(FuzzReport, HoldsTheSameAsTextJsonPictureAndPage) {
  const Folder folder;
  const Outcome o = run(command("wrong", "naive_orient3d") + "--cases 60" + kFewGenerators + "--out " + (folder / "r"));
  EXPECT_EQ(o.code, 1);
  EXPECT_THAT(o.out, StartsWith(content(folder / "r/fuzz.txt")));
  const json report = json::parse(content(folder / "r/fuzz.json"));
  const std::vector<std::string> lines = replay_lines(o.out);
  ASSERT_EQ(report.at("findings").size(), lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ("$PLUMB" + std::string(report.at("findings")[i].at("again")).substr(5), lines[i]);
    const std::string stem = folder / ("r/case-" + std::to_string(i + 1));
    EXPECT_THAT(content(stem + ".cpp"), HasSubstr("naive_orient3d("));
    EXPECT_THAT(content(stem + ".py"), HasSubstr("float.fromhex"));
    EXPECT_THAT(content(stem + ".obj"), HasSubstr("\nv "));
  }
  const std::string svg = content(folder / "r/fuzz.svg");
  for (const json& g : report.at("generators")) EXPECT_THAT(svg, HasSubstr(">" + std::string(g.at("generator")) + "<"));
  std::string page = content(folder / "r/fuzz.html");
  for (std::size_t at = 0; (at = page.find("http://www.w3.org/2000/svg")) != std::string::npos;) page.erase(at, 26);
  EXPECT_THAT(page, AllOf(StartsWith("<!DOCTYPE html>"), HasSubstr("<svg"), Not(HasSubstr("http:"))));
  for (const auto& entry : fs::directory_iterator(folder / "r")) EXPECT_NE(entry.path().extension(), ".part");
  // The cases of an older report do not stay beside a newer one.
  run(command("right", "right_orient3d") + "--cases 1 --out " + (folder / "r"));
  EXPECT_FALSE(fs::exists(folder / "r/case-1.cpp"));
}

TEST(FuzzReport, ArrivesWithItsCorpusOrNeitherDoes) {
  const Folder folder;
  const std::string line = command("wrong", "naive_orient3d") + "--cases 60" + kFewGenerators + "--corpus " +
                           (folder / "c") + " --out " + (folder / "r");
  EXPECT_EQ(run(line + " >/dev/full").code, 2);
  EXPECT_FALSE(fs::exists(folder / "c") || fs::exists(folder / "r"));
  EXPECT_EQ(run(line).code, 1);
  EXPECT_TRUE(fs::exists(folder / "c") && fs::exists(folder / "r/fuzz.json"));
}

TEST(FuzzReport, TakesTextInAnyEncoding) {
  const Folder folder;
  const Outcome o = run(command("throws", "latin_orient3d") + "--cases 1 --generator grid --out " + (folder / "r"));
  EXPECT_EQ(o.code, 1) << o.err;
  EXPECT_THAT(content(folder / "r/fuzz.html"), HasSubstr("nicht m\xEF\xBF\xBDglich"));
}

TEST(FuzzReport, LeavesAnOlderOneWholeWhereItCannotBeWritten) {
  const Folder folder;
  fs::create_directories(folder / "r/fuzz.svg");
  std::ofstream(folder / "r/fuzz.txt") << "old\n";
  std::ofstream(folder / "r/.plumb-fuzz-files") << "fuzz.txt\n";
  const Outcome o = run(command("right", "right_orient3d") + "--cases 1 --out " + (folder / "r"));
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, HasSubstr("fuzz.svg is there already"));
  EXPECT_EQ(content(folder / "r/fuzz.txt"), "old\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "r"), {}), 3);
}

TEST(FuzzCommand, ListsKindsAndGenerators) {
  const Outcome kinds = run("$PLUMB fuzz --list");
  EXPECT_EQ(kinds.code, 0);
  for (const char* words : {"orient2d", "insphere", "triangle-triangle", "hull", "double f(const double"})
    EXPECT_THAT(kinds.out, HasSubstr(words));
  const Outcome generators = run("$PLUMB fuzz --list --kind orient3d");
  EXPECT_EQ(generators.code, 0);
  EXPECT_THAT(generators.out, AllOf(HasSubstr("  degenerate_long"), HasSubstr("  mutated")));
}

TEST(FuzzCommand, RefusesWhatCannotBeLoadedOrCalled) {
  const Folder folder;
  std::ofstream(folder / "text.so") << "hello\n";
  const auto library = [](const std::string& path) {
    return "$PLUMB fuzz --kind orient3d --library " + path + " --symbol f --timeout 0.05";
  };
  for (const std::string& path : {folder / "none.so", folder / "text.so", folder / ".", std::string("/dev/null")})
    expect_refusal(run(library(path)), path);
  expect_refusal(run(library(module("load_crashes"))), "crashed (SIGABRT)");
  expect_refusal(run(library(module("load_hangs"))), "hung");
  expect_refusal(run(command("wrong", "missing")), "no symbol missing");
  expect_refusal(run(command("wrong", "an_object")), "an_object in ");
}

TEST(FuzzCommand, RefusesWhatMakesNoSense) {
  const std::string naive = command("wrong", "naive_orient3d");
  expect_refusal(run("$PLUMB fuzz"), "--kind");
  expect_refusal(run("$PLUMB fuzz --kind orient3d --symbol f"), "--library");
  expect_refusal(run(command("wrong", "naive_orient3d", "orient4d")),
                 "--kind: there is no kind orient4d (did you mean orient");
  expect_refusal(run("$PLUMB fuzz --list --kind trangle-triangle"), "(did you mean triangle-triangle?)");
  expect_refusal(run(naive + "--answer sign"), "--argument");
  for (const char* words :
       {"--cases 0", "--cases -1", "--time 0", "--time nan", "--time 1e300", "--timeout 0", "--memory 0",
        "--relative -1", "--seed -1", "--generator odd", "--format odd", "--odd", "--case 'orient3d 1 2'",
        "--case 'orient2d 0 0 1 0 0 1'", "--case ''", "--case '0 0 0 0 0 0 0 0 0 0 0 0' --out r",
        "--out /no/such/folder", "--out /dev/null", "--corpus /proc/folder"})
    expect_refusal(run(naive + words), "");
  EXPECT_EQ(run(naive + "--cases 10 >/dev/full").code, 2);
}

}  // namespace
}  // namespace plumb::tool
