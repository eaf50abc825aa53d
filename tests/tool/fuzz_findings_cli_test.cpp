// What users declare and are handed: conventions, ranges, kinds of their own; scripts and drawings of what was found.
#include <cmath>
#include <fstream>

#include "plumb/query/kinds/kinds.hpp"
#include "tool/fuzz/drawing.hpp"
#include "tool/fuzz_commands.hpp"

namespace plumb::tool {
namespace {

using testing::AnyOf;

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
                 "--boundary makes no difference to orient3d");
  expect_refusal(run(command("wrong", "crossing_polygon", "point-in-polygon") + "--boundary out --judge " +
                     module("wrong") + ":crossing_polygon"),
                 "--boundary is for the judge to decide");
  expect_refusal(run(command("wrong", "epsilon_triangles", "triangle-triangle") + "--ends open"),
                 "--ends makes no difference to triangle-triangle");
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
  using Refused = std::pair<const char*, const char*>;
  for (const auto& [words, option] :
       {Refused{"--range 0", "--range: "}, Refused{"--range -1", "--range: "}, Refused{"--range nan", "--range: "},
        Refused{"--grid 0.1", "--grid: "}, Refused{"--bits 0", "--bits: "}, Refused{"--bits 54", "--bits: "},
        Refused{"--range 1 --smallest 2", "--smallest: "}, Refused{"--range 0.25 --grid 1", "--grid: "},
        Refused{"--range 7 --smallest 5 --grid 4", "--smallest: "}})
    expect_refusal(run(line + words), option);
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

TEST(FuzzOwnKind, HasConventionsOfTheJudgeAlone) {
  const std::string judge = " --judge " + module("wrong") + ":nearer_exactly ";
  expect_refusal(run(command("wrong", "nearer", "site") + kSites + judge + "--ends open"),
                 "--ends is for the judge to decide");
}

/// A judge that does not tell where a ray hits leaves that to the function.
TEST(FuzzOwnKind, IsNotHeldToWhatTheJudgeLeavesOpen) {
  const std::string rays = command("wrong", "always_hit", "ray-triangle") + "--cases 30 --judge " + module("wrong");
  EXPECT_EQ(run(rays + ":hit_without_parameter").code, 0);
  const std::string one = " --case '0 0 0 0 0 1 0 0 1 1 0 0 0 0 0' --format python";
  const Outcome o =
      run(rays.substr(0, rays.find("--cases")) + "--judge " + module("wrong") + ":hit_without_parameter" + one);
  EXPECT_THAT(o.out, HasSubstr("EXACT = \"yes\"")) << o.err;
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

TEST(FuzzDrawing, ShowsCirclesAndWhatFallsTogetherFromNear) {
  const degenerate::Kind &circle = degenerate::kind_named("incircle"), &turn = degenerate::kind_named("orient2d");
  const std::string inside = case_drawings(circle, {1, 0, 0, 1, -1, 0, 0, -0x1.fffffffffffffp-1});
  EXPECT_THAT(inside, AllOf(HasSubstr("<circle class=\"axis\""),
                            HasSubstr("To scale. The last point is inside of the circle, by 1.1e-16 of its radius.")));
  EXPECT_THAT(case_drawings(circle, {1, 0, 0, 1, -1, 0, 0, -1}), HasSubstr("is on the circle."));
  EXPECT_THAT(case_drawings(circle, {1, 0, 2, 0, 3, 0, 0, -1}), HasSubstr("The first three lie in line."));
  // Nearly in line: stretched until the turn is seen, and c is drawn left of the way from a to b, above it.
  const std::string near = case_drawings(turn, {0, 0, 2, 0, 1, 0x1p-52});
  EXPECT_THAT(near, HasSubstr("Along the longest distance to scale, across stretched 2.7e+15 times."));
  // Of two pairs of neighbors each is drawn once more.
  const degenerate::Kind& segments = degenerate::kind_named("segment-segment");
  const degenerate::Numbers pairs{0, 0, 1, 0, 0x1p-60, 0, 1, 1};
  EXPECT_THAT(case_drawings(segments, pairs), HasSubstr("From near: a0, b0. "));
  EXPECT_THAT(near_coincidences(turn, {0.5, 0, 0x1.0000000000001p-1, 0, 1, 1}),
              AllOf(HasSubstr("<td>a.x</td><td>0.5</td><td>b.x</td>"), HasSubstr("<td>1.11e-16</td><td>1</td>")));
  EXPECT_EQ(near_coincidences(turn, {0, 0, 2, 0, 1, 1}), "");
}

}  // namespace
}  // namespace plumb::tool
