// `plumb check` as a user meets it: reports, files written and refused, exit codes, the sample, the replay of what it
// found.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "matchers.hpp"
#include "run_program.hpp"
#include "tool/check_command.hpp"

namespace plumb::tool {
namespace {

json report_of(const std::string& arguments, int code = 0) {
  const Outcome o = run("$PLUMB check --json - " + arguments);
  EXPECT_EQ(o.code, code) << o.err;
  return json::parse(o.out);
}

void put(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

TEST(Check, RunsOnTheEmbeddedPartWhenGivenNothing) {
  const Outcome o = run("$PLUMB check");
  EXPECT_EQ(o.code, 0);
  EXPECT_EQ(o.err, "");  // no progress bar where nobody looks
  EXPECT_THAT(o.out, Not(HasSubstr("\033")));
  for (const std::string_view method : method_names) EXPECT_THAT(o.out, HasSubstr(std::string(method)));
  for (const char* name : {"orient2d", "orient3d", "incircle", "insphere"}) EXPECT_THAT(o.out, HasSubstr(name));
}

TEST(Check, FindsFloatsWrongAndTheExactSignsRight) {
  const json total = report_of("--verify").at("meshes").at(0).at("total");
  std::set<std::string> seen;
  for (const json& m : total.at("methods")) {
    const std::string name = m.at("method");
    seen.insert(name);
    const int wrong = m.at("wrong");
    if (name == "exact" || name == "plan" || name == "interval") {
      EXPECT_EQ(wrong, 0) << name;
    } else if (name != "long-double") {  // which is wide enough on some processors
      EXPECT_GT(wrong, 0) << name;
    }
    EXPECT_EQ(m.at("decisions"), total.at("decisions"));
  }
  EXPECT_EQ(seen.size(), method_names.size());
}

TEST(Check, GivesTheSameAnswersOnEveryNumberOfThreads) {
  const auto without_times = [](json report) {
    json answers = json::array();
    for (const json& m : report.at("meshes").at(0).at("total").at("methods")) {
      answers.push_back({m.at("method"), m.at("wrong"), m.at("unsure"), m.at("zeros_missed"), m.at("zeros_invented"),
                         m.contains("worst") ? m.at("worst") : json()});
    }
    return answers;
  };
  const json one = without_times(report_of("--threads 1"));
  EXPECT_EQ(one, without_times(report_of("--threads 2")));
  EXPECT_EQ(one, without_times(report_of("--threads 7")));
}

TEST(Check, FailsOnWrongSignsWhereAskedTo) {
  EXPECT_EQ(run("$PLUMB check --fail-on-wrong double").code, 1);
  EXPECT_EQ(run("$PLUMB check --fail-on-wrong exact").code, 0);
  EXPECT_EQ(run("$PLUMB check --fail-on-wrong exact --fail-on-wrong float32").code, 1);
  EXPECT_EQ(run("$PLUMB check --fail-on-wrong interval --verify").code, 0);
}

TEST(Check, NamesWorstCasesThatSignReplays) {
  int replayed = 0;
  const json report = report_of("");
  for (const json& m : report.at("meshes").at(0).at("total").at("methods")) {
    if (!m.contains("worst") || m.at("worst").is_null()) continue;
    const std::string line = m.at("worst").at("case");
    const Outcome o = run("$PLUMB sign", line + "\n");
    EXPECT_EQ(o.code, 0) << line;  // its "= sign" is the exact one
    EXPECT_EQ(o.out.front(), line.back());
    ++replayed;
  }
  EXPECT_GE(replayed, 4);
}

TEST(Check, ReadsItsOwnSampleFromEveryFormat) {
  const Folder folder;
  const json own = report_of("").at("meshes").at(0);
  for (const std::string name : {"s.obj", "s.off", "s.ply", "s.stl"}) {
    EXPECT_EQ(run("$PLUMB check --write-sample " + (folder / name)).code, 0);
    const json read = report_of(folder / name).at("meshes").at(0);
    EXPECT_EQ(read.at("statistics").at("triangles"), own.at("statistics").at("triangles")) << name;
    EXPECT_EQ(read.at("statistics").at("zero_area_triangles"), 12) << name;
    if (name == "s.stl") continue;  // it knows no indices: what was repeated is merged
    for (const char* part : {"statistics", "lattice", "edges"}) EXPECT_EQ(read.at(part), own.at(part)) << name << part;
  }
}

TEST(Check, ChecksSeveralMeshesAndDrawsThem) {
  const Folder folder;
  put(folder / "one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  run("$PLUMB check --write-sample " + (folder / "-s.obj"));
  const std::string chart = folder / "chart.svg", report = folder / "report.json";
  const Outcome o = run("$PLUMB check " + (folder / "one.obj") + " --chart " + chart + " --json " + report + " -- " +
                        (folder / "-s.obj"));
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.out, AllOf(HasSubstr("one.obj"), HasSubstr("-s.obj")));
  EXPECT_EQ(json::parse(content(report)).at("meshes").size(), 2U);
  EXPECT_THAT(content(chart), AllOf(StartsWith("<svg"), HasSubstr(">exact"), HasSubstr(">float32")));
}

TEST(Check, TakesNamesOfAnyBytes) {
  const Folder folder;
  const std::string mesh = folder / "na\xFF\xFEme.obj", chart = folder / "chart.svg";
  put(mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const json report = report_of(mesh);
  EXPECT_THAT(std::string(report.at("meshes").at(0).at("name")), testing::EndsWith("na\uFFFD\uFFFDme.obj"));
  EXPECT_EQ(run("$PLUMB check --chart " + chart + " " + mesh).code, 0);
  EXPECT_THAT(content(chart), AllOf(HasSubstr("na\uFFFD\uFFFDme.obj"), Not(HasSubstr("\xFF"))));
}

TEST(Check, RefusesEachBadFileInItsOwnWords) {
  const Folder folder;
  put(folder / "empty.obj", "");
  put(folder / "text.obj", "hello\n");
  put(folder / "points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  put(folder / "index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  put(folder / "number.obj", "v 0 0 0\nv 1 0 zero\nv 0 1 0\nf 1 2 3\n");
  put(folder / "nan.obj", "v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n");
  put(folder / "short.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n");
  std::set<std::string> words;
  for (const std::string name :
       {"missing.obj", "empty.obj", "text.obj", "points.obj", "index.obj", "number.obj", "nan.obj", "short.ply", "."}) {
    const Outcome o = run("$PLUMB check " + (folder / name));
    EXPECT_EQ(o.code, 2) << name;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb: " + (folder / name)), testing::EndsWith("\n"))) << name;
    words.insert(o.err.substr(o.err.find(": ", 8)));
  }
  EXPECT_EQ(words.size(), 9U);
  EXPECT_THAT(run("$PLUMB check " + (folder / "index.obj")).err, HasSubstr("index.obj:4: "));
}

TEST(Check, ChecksTheOtherMeshesBesideABadOne) {
  const Folder folder;
  put(folder / "one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Outcome o = run("$PLUMB check " + (folder / "missing.obj") + " " + (folder / "one.obj"));
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, HasSubstr("missing.obj"));
  EXPECT_THAT(o.out, HasSubstr("one.obj"));
}

TEST(Check, RefusesOutputsThatCannotBeWritten) {
  for (const std::string option : {"--json", "--chart"}) {
    const Outcome full = run("$PLUMB check " + option + " /dev/full");
    EXPECT_EQ(full.code, 2) << option;
    EXPECT_THAT(full.err, AllOf(StartsWith("plumb: "), HasSubstr("/dev/full"), HasSubstr("No space"))) << option;
    EXPECT_EQ(run("$PLUMB check " + option + " /no/such/folder/file").code, 2) << option;
  }
  EXPECT_EQ(run("$PLUMB check >/dev/full").code, 2);
  EXPECT_EQ(run("$PLUMB check --write-sample /no/such/folder/file.obj").code, 2);
  EXPECT_THAT(run("$PLUMB check --write-sample /tmp/mesh.xyz").err, HasSubstr(".obj, .off, .stl or .ply"));
}

TEST(Check, UsesColorsOnATerminalOnly) {
  if (!has_terminals()) return;
  const Outcome o = run_on_terminal("unset NO_COLOR; $PLUMB check");
  EXPECT_EQ(o.code, 0);
  EXPECT_THAT(o.out, HasSubstr("\033["));
}

}  // namespace
}  // namespace plumb::tool
