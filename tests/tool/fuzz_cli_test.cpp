// `plumb fuzz` as a user meets it: faulty functions are found, right ones are not, and no foreign code spoils the run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "run_program.hpp"

namespace plumb::tool {
namespace {

namespace fs = std::filesystem;

using nlohmann::json;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Shrinking takes its time for each.
const std::string kFewGenerators = " --generator uniform --generator near_half --generator degenerate_long ";

std::string module(const std::string& name) { return PLUMB_FOREIGN "/" + name + ".so"; }

std::string command(const std::string& name, const std::string& symbol, const std::string& kind = "orient3d") {
  return "$PLUMB fuzz --kind " + kind + " --library " + module(name) + " --symbol " + symbol + " ";
}

/// Lines that ask a finding again, in the order of the findings.
std::vector<std::string> replay_lines(const std::string& out) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; (at = out.find("\nplumb fuzz ", at)) != std::string::npos; ++at)
    lines.push_back("$PLUMB" + out.substr(at + 6, out.find('\n', at + 1) - at - 6));
  return lines;
}

/// The line that begins with this.
std::string line_of(const std::string& out, const std::string& begin) {
  const std::size_t at = out.find("\n" + begin);
  return at == std::string::npos ? "" : out.substr(at + 1, out.find('\n', at + 1) - at - 1);
}

void expect_refusal(const Outcome& o, const std::string& words) {
  EXPECT_EQ(o.code, 2) << o.out;
  EXPECT_EQ(o.out, "");
  EXPECT_THAT(o.err, AllOf(StartsWith("plumb: "), HasSubstr(words)));
  EXPECT_EQ(std::ranges::count(o.err, '\n'), 1) << o.err;
}

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

/// What the case's script says and exits with, written by `--case CASE --format python`.
Outcome run_script(const std::string& name, const std::string& symbol, const std::string& kind,
                   const std::string& numbers, const std::string& more = "") {
  const Folder folder;
  const std::string script = folder / "case.py";
  const Outcome o = run(command(name, symbol, kind) + "--case '" + numbers + "' --format python " + more);
  const std::size_t begin = o.out.find("#!/usr/bin/env python3");
  EXPECT_NE(begin, std::string::npos) << o.out << o.err;
  if (begin == std::string::npos) return o;
  std::ofstream(script) << o.out.substr(begin);
  return run("python3 " + script);
}

TEST(FuzzPython, IsAScriptThatAsksAgain) {
  const std::string flat = "0 0 0 1 0 0 0 1 0 1 1 0", solid = "0 0 0 1 0 0 0 1 0 0 0 -1";
  struct Case {
    std::string symbol, kind, numbers, told;
    int code;
  };
  const std::string ray_hits = "0.25 0.25 1 0 0 -2 3 0 0 0 1 0 0 0 1 0 1 0 1 2",
                    ray_on_edge = "0.5 0.5" + ray_hits.substr(9);
  const std::string four = "4 0 0 0 1 0 0 0 1 0 0 0 1", five = "5" + four.substr(1) + " 1 1 1";
  for (const Case& c : {
           Case{"naive_orient3d", "orient3d", solid, "right: given 1.0, exact 1", 0},
           Case{"naive_orient3d", "orient3d", "0x1p-600 0 0 0 0x1p-600 0 0 0 0x1p-600 0 0 0", "wrong: given 0.0, exact",
                1},
           Case{"crashing_orient3d", "orient3d", "0 0 0 0 0 0 0 0 0 0 0 0", "wrong: given crashed (SIGABRT)", 1},
           Case{"hanging_orient3d", "orient3d", flat, "wrong: given hung", 1},
           Case{"leaving_orient3d", "orient3d", flat, "wrong: given exited (with code 3)", 1},
           Case{"greedy_orient3d", "orient3d", solid, "wrong: given crashed (SIGSEGV)", 1},
           Case{"talking_orient3d", "orient3d", solid, "right: given 1.0, exact 1", 0},
           Case{"crossing_polygon", "point-in-polygon", "1 1 4 0 0 2 0 2 2 0 2", "right: given 1, exact True", 0},
           Case{"crossing_polygon", "point-in-polygon", "2 1 4 0 0 2 0 2 2 0 2", "wrong: given 0, exact True", 1},
           Case{"leaking_ray_mesh", "ray-mesh", ray_hits, "right: given 0.5, exact 0.5", 0},
           Case{"leaking_ray_mesh", "ray-mesh", ray_on_edge, "wrong: given None, exact 0.5", 1},
           Case{"distance_on_axis", "convex-distance", "1 0 0 0 1 3 0 0", "right: given 3.0, exact 3.0", 0},
           Case{"distance_on_axis", "convex-distance", "1 0 0 0 1 3 4 0", "wrong: given 3.0, exact 5.0", 1},
           Case{"hull_of_four", "hull", four, "right: given [", 0},
           Case{"hull_of_four", "hull", five, "wrong: given []", 1},
       }) {
    const std::string limit = c.told.find("hung") == std::string::npos ? "" : "--timeout 0.1";
    const Outcome o = run_script("wrong", c.symbol, c.kind, c.numbers, limit);
    EXPECT_EQ(o.code, c.code) << c.symbol << ' ' << c.numbers << o.out << o.err;
    EXPECT_THAT(o.out, StartsWith(c.told)) << c.symbol << o.err;
    EXPECT_EQ(o.err, "");
  }
  EXPECT_EQ(run_script("wrong", "crossing_polygon", "point-in-polygon", "2 1 4 0 0 2 0 2 2 0 2", "--boundary any").code,
            0);
  EXPECT_EQ(run_script("wrong", "distance_on_axis", "convex-distance", "1 0 0 0 1 3 4 0", "--relative 0.5").code, 0);
}

TEST(FuzzPython, AndCppOfAReportFailUntilTheFunctionIsRight) {
  const Folder folder;
  run(command("wrong", "naive_orient3d") + "--cases 60" + kFewGenerators + "--out " + (folder / "r"));
  const Outcome wrong = run("python3 " + (folder / "r/case-1.py"));
  EXPECT_EQ(wrong.code, 1) << wrong.err;
  EXPECT_THAT(wrong.out, StartsWith("wrong: given "));
  const std::string script = content(folder / "r/case-1.py");
  std::string other = script;
  for (std::size_t at = 0; (at = other.find("naive_orient3d")) != std::string::npos;)
    other.replace(at, 14, "right_orient3d");
  std::ofstream(folder / "right.py") << other;
  const Outcome right = run("python3 " + (folder / "right.py") + " " + module("right"));
  EXPECT_EQ(right.code, 0) << right.out << right.err;
  EXPECT_EQ(run("python3 " + (folder / "right.py")).code, 2);  // no such symbol in the library that it names
  const Outcome built = run("c++ -std=c++20 " + (folder / "r/case-1.cpp") + " " + module("wrong") + " -o " +
                            (folder / "case") + " -lgtest -lgtest_main");
  ASSERT_EQ(built.code, 0) << built.err;
  EXPECT_EQ(run(folder / "case").code, 1);
}

TEST(FuzzConvention, IsDeclaredBySwitches) {
  const std::string line =
      command("wrong", "crossing_polygon", "point-in-polygon") + "--cases 150 --generator boundary ";
  const Outcome closed = run(line), any = run(line + "--boundary any");
  EXPECT_EQ(closed.code, 1) << closed.err;
  EXPECT_EQ(any.code, 0) << any.out;
  EXPECT_THAT(any.out, HasSubstr("; --boundary any\n"));
  const Outcome out = run(line + "--boundary out");
  EXPECT_EQ(out.code, 1);
  EXPECT_THAT(out.out, AllOf(HasSubstr("given yes, exact no"), Not(HasSubstr("given no, exact yes"))));
  ASSERT_FALSE(replay_lines(out.out).empty());
  EXPECT_THAT(replay_lines(out.out)[0], HasSubstr(" --boundary out --case "));
  EXPECT_EQ(run(replay_lines(out.out)[0]).code, 1);
  EXPECT_THAT(run("$PLUMB fuzz --list").out,
              AllOf(HasSubstr("--boundary in|out|any"), HasSubstr("--ends closed|open|any")));
  expect_refusal(run(command("wrong", "naive_orient3d") + "--boundary out"),
                 "boundaries make no difference to orient3d");
  expect_refusal(run(command("wrong", "naive_orient3d") + "--ends odd"), "--ends");
}

TEST(FuzzDomain, IsDeclaredBySwitchesAndKept) {
  const Folder folder;
  const std::string line = command("wrong", "naive_orient3d") + "--cases 200 ";
  // Differences of 11 bits, products of 36: nothing rounds.
  EXPECT_EQ(run(line + "--range 1000 --grid 1").code, 0);
  const Outcome o = run(line + "--range 1e6 --smallest 1e-3 --bits 40 --no-degenerate --out " + (folder / "r"));
  EXPECT_EQ(o.code, 1) << o.err;
  const json report = json::parse(content(folder / "r/fuzz.json"));
  EXPECT_EQ(report.at("declared"), " --no-degenerate --range 1000000 --smallest 0.001 --bits 40");
  EXPECT_GE(report.at("findings").size(), 1u);
  for (const json& finding : report.at("findings")) {
    EXPECT_THAT(std::string(finding.at("sort")), Not(HasSubstr("for 0")));
    for (const json& number : finding.at("numbers")) {
      const double x = std::abs(std::strtod(std::string(number).c_str(), nullptr));
      EXPECT_TRUE(x == 0 || (x >= 1e-3 && x <= 1e6)) << number;
    }
    EXPECT_EQ(run("$PLUMB" + std::string(finding.at("again")).substr(5)).code, 1);
  }
  for (const char* words : {"--range 0", "--range -1", "--range nan", "--grid 0.1", "--bits 0", "--bits 54",
                            "--range 1 --smallest 2", "--range 0.25 --grid 1"})
    expect_refusal(run(line + words), "domain: ");
}

const std::string kSites =
    " --argument p:point2 --argument a:point2 --argument b:point2 --bits 24 --smallest 1e-3 --range 1e3 --cases 100 ";

TEST(FuzzOwnKind, IsJudgedByAFunctionOfTheUsers) {
  const Folder folder;
  const std::string judge = " --judge " + module("wrong") + ":nearer_exactly";
  const Outcome o = run(command("wrong", "nearer", "site") + kSites + judge + " --out " + (folder / "r"));
  EXPECT_EQ(o.code, 1) << o.out << o.err;
  EXPECT_THAT(line_of(o.out, "  at_change"), Not(HasSubstr(" 0 %")));
  const std::vector<std::string> lines = replay_lines(o.out);
  ASSERT_FALSE(lines.empty());
  for (const std::string& line : lines) EXPECT_EQ(run(line).code, 1) << line;
  EXPECT_EQ(run("python3 " + (folder / "r/case-1.py")).code, 1);
  EXPECT_EQ(run(command("wrong", "nearer_exactly", "site") + kSites + judge).code, 0);
  // With a kind that there is, the judge's answers are the right ones.
  const std::string polygon = command("wrong", "crossing_polygon", "point-in-polygon") + "--cases 50 ";
  EXPECT_EQ(run(polygon).code, 1);
  EXPECT_EQ(run(polygon + "--judge " + module("wrong") + ":crossing_polygon").code, 0);
}

TEST(FuzzOwnKind, IsRefusedWhereNobodyCanJudge) {
  const std::string site = command("wrong", "nearer", "site");
  expect_refusal(run(site + kSites), "--judge is wanted");
  expect_refusal(run(site + kSites + "--judge " + module("wrong")), "FILE:SYMBOL");
  expect_refusal(run(site + kSites + "--judge odd"), "FILE:SYMBOL");
  expect_refusal(run(site + kSites + "--judge " + module("wrong") + ":missing"), "no symbol missing");
  expect_refusal(run(site + kSites + "--judge " + module("wrong") + ":no_judge"),
                 "no answer: crashed (SIGABRT); the case is");
  const std::string judge = " --judge " + module("wrong") + ":nearer_exactly ";
  for (const char* word : {"p", "p:", ":point2", "p:point", "p:plane3", "p:points4", "p:point2,", "1p:point2"})
    expect_refusal(run(site + judge + "--argument " + word), "is no argument");
  expect_refusal(run(command("wrong", "nearer", "orient2d") + kSites + judge), "another name");
  expect_refusal(run(command("wrong", "hull_of_four", "hull") + judge), "many answers of hull are right");
}

TEST(FuzzOwnKind, IsEveryPredicateByName) {
  EXPECT_THAT(run("$PLUMB fuzz --list").out, HasSubstr(" compare_distance2d"));
  EXPECT_THAT(run("$PLUMB fuzz --list --kind compare_distance2d").out,
              AllOf(HasSubstr("double f("), HasSubstr("at_change")));
  const Outcome o = run(command("wrong", "naive_orient3d", "order_along_line3d") + "--cases 20");
  EXPECT_EQ(o.code, 1) << o.err;
}

TEST(FuzzReport, DrawsEachFindingAndTellsWhatAllButCoincides) {
  const Folder folder;
  const auto page = [&](const std::string& line) {
    run(line + " --out " + (folder / "r"));
    return content(folder / "r/fuzz.html");
  };
  const std::string points = page(command("wrong", "naive_orient3d") + "--cases 60" + kFewGenerators);
  const auto count = [](const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at) ++found;
    return found;
  };
  EXPECT_EQ(count(points, "<figure><svg"), count(points, "<article>\n<h3>"));
  EXPECT_GE(count(points, "<figure><svg"), 2u);
  EXPECT_THAT(points, AnyOf(HasSubstr("height stretched"), HasSubstr("To scale")));
  const std::string triangles =
      page(command("wrong", "epsilon_triangles", "triangle-triangle") + "--cases 30 --generator near_half");
  EXPECT_THAT(triangles, AllOf(HasSubstr("<polygon class=\"s0 drawn\""), HasSubstr("<polygon class=\"s1 drawn\""),
                               HasSubstr(">a0"), Not(testing::ContainsRegex("points=\"[^\"]*(nan|inf)"))));
  for (const char* kind : {"ray-mesh", "point-in-polygon"}) {
    const std::string symbol = std::string(kind) == "ray-mesh" ? "leaking_ray_mesh" : "crossing_polygon";
    const std::string drawn = page(command("wrong", symbol, kind) + "--cases 50");
    EXPECT_GE(count(drawn, "<figure><svg"), 1u) << kind;
  }
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
  const Outcome o = run(command("right", "right_orient3d") + "--cases 1 --out " + (folder / "r"));
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, HasSubstr("fuzz.svg: Is a directory"));
  EXPECT_EQ(content(folder / "r/fuzz.txt"), "old\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "r"), {}), 2);
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
  expect_refusal(run(command("wrong", "naive_orient3d", "orient4d")), "orient3d");
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
