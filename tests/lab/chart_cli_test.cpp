// `plumb-lab chart` as a user meets it: what is measured, what is written and refused, and that a page of it works.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "lab/quick_report.hpp"
#include "tool/browser.hpp"
#include "tool/drawing/chart.hpp"

namespace plumb::lab {
namespace {

const std::set<std::string> kAlwaysRight{"integers", "rationals", "plan",  "exact",
                                         "batch",    "columns",   "sweep", "brute-force"};
const std::set<std::string> kNeverWrong{"interval", "static-filter"};
/// Tasks whose common code leaves out some inputs, in whatever numbers.
const std::set<std::string> kIncomplete{
    "ray-triangle",           "segment-triangle",    "triangle-triangle",  "obb-obb",
    "point-in-polygon",       "point-in-polyhedron", "vertex-face-motion", "edge-edge-motion",
    "point-triangle-distance"};
/// Tasks on meshes, on many things and on polygons to be cut: other methods, and answers in full.
const std::set<std::string> kOfMany{"closest-hit", "mesh-pairs",    "mesh-distance", "closest-point-on-mesh",
                                    "box-pairs",   "nearest-point", "grid-walk",     "triangulation",
                                    "welding"};
const std::set<std::string> kListing{"mesh-pairs", "mesh-distance", "box-pairs",
                                     "grid-walk",  "triangulation", "welding"};  // take memory
const std::set<std::string> kOfTheCode{"interval", "static-filter", "adaptive", "integers", "rationals"};  // branching
const std::set<std::string> kUnderflowing{"extreme", "mixture", "off_by_ulps", "repeated"};  // or overflowing

const QuickReport& report() {
  static const QuickReport once("chart");
  return once;
}

/// Calls see(task, class, method's entry) for all.
template <class See>
void each(See see) {
  for (const json& trial : report().raw.at("trials")) {
    for (const json& m : trial.at("methods")) see(std::string(trial.at("task")), std::string(trial.at("class")), m);
  }
}

/// How many trials have this value under the key.
std::size_t trials_with(const std::string& key, const std::string& value) {
  return static_cast<std::size_t>(
      std::ranges::count_if(report().raw.at("trials"), [&](const json& trial) { return trial.at(key) == value; }));
}
/// How many trials have the method `double`.
std::size_t doubles() {
  std::size_t count = 0;
  each([&](const std::string&, const std::string&, const json& m) { count += m.at("method") == "double"; });
  return count;
}
std::size_t methods() {
  std::set<std::string> names;
  each([&](const std::string&, const std::string&, const json& m) { names.insert(m.at("method")); });
  return names.size();
}
std::size_t tasks() {
  std::set<std::string> names;
  for (const json& trial : report().raw.at("trials")) names.insert(trial.at("task"));
  return names.size();
}

TEST(Report, HasATableAPictureAndAnEntryForEveryTaskAndClass) {
  EXPECT_EQ(report().outcome.code, 0);
  EXPECT_EQ(report().outcome.err, "");  // no progress bar where nobody looks
  EXPECT_THAT(report().outcome.out, Not(HasSubstr("\033")));
  EXPECT_THAT(report().outcome.out, StartsWith(report().table));
  std::map<std::string, int> classes;
  for (const json& trial : report().raw.at("trials")) {
    const std::string task = trial.at("task"), input = trial.at("class");
    ++classes[task];
    EXPECT_THAT(report().table, HasSubstr(task + ", " + input + ": "));
    const std::string svg = report().file(task + "-" + input + ".svg");
    EXPECT_THAT(svg, AllOf(StartsWith("<svg"), HasSubstr(">" + task + ", " + input + "</text>"),
                           HasSubstr("class=\"frontier\"")));
    for (const json& m : trial.at("methods")) EXPECT_THAT(svg, HasSubstr("data-key=\"" + std::string(m.at("method"))));
  }
  for (const char* task : {"orient2d", "orient3d", "incircle", "insphere"}) EXPECT_EQ(classes[task], 12) << task;
  for (const auto& entry : std::filesystem::directory_iterator(report().folder())) {
    EXPECT_THAT(entry.path().string(), Not(HasSubstr(".part")));
  }
}

/// What is kept of a run (docs/charts.md) is made by a script.
TEST(Report, HasItsMediansTakenOutByTheScript) {
  const Outcome taken =
      run("python3 " PLUMB_SOURCE_DIR "/tests/bench/report/chart_medians.py < " + report().folder() + "/chart.json");
  EXPECT_EQ(taken.err, "");
  const json kept = json::parse(taken.out, nullptr, false);
  ASSERT_TRUE(kept.is_object()) << taken.out;
  EXPECT_EQ(kept.at("machine"), report().raw.at("machine"));
  EXPECT_EQ(kept.at("medians").size(), report().raw.at("trials").size());
  each([&](const std::string& task, const std::string& input, const json& m) {
    const json& row = kept.at("medians").at(task + ", " + input).at(std::string(m.at("method")));
    EXPECT_EQ(row[0], m.at("wrong")) << task << " " << input << " " << m;
    EXPECT_NEAR(double(row[2]), double(m.at("query_ns")), 0.005 * double(m.at("query_ns"))) << task << " " << input;
  });
}

TEST(Report, HasNoMethodThatIsWrongOnHalfOfWhatIsHarmless) {
  const std::string script = "python3 " PLUMB_SOURCE_DIR "/tests/bench/report/sane_methods.py";
  const Outcome sane = run(script + " < " + report().folder() + "/chart.json");
  EXPECT_EQ(sane.code, 0) << sane.err;
  json raw = report().raw;
  json& trial = *std::ranges::find_if(raw.at("trials"), [](const json& t) { return t.at("class") == "uniform"; });
  json& method = trial.at("methods").at(0);
  method["wrong"] = method.at("asked");
  const Outcome broken = run(script, raw.dump());
  EXPECT_EQ(broken.code, 1);
  EXPECT_THAT(broken.err, testing::HasSubstr(": orient2d: " + method.at("method").get<std::string>()));
  EXPECT_NE(run(script, R"({"trials": []})").code, 0);
}

TEST(Report, SaysWhereAndWhenItWasMade) {
  for (const char* key : {"version", "compiler", "flags", "machine", "date"}) {
    EXPECT_THAT(std::string(report().raw.at(key)), Not(testing::IsEmpty())) << key;
  }
  EXPECT_THAT(std::string(report().raw.at("date")),
              testing::MatchesRegex("[0-9]+-[0-9]+-[0-9]+T[0-9]+:[0-9]+:[0-9]+Z"));
  EXPECT_EQ(report().raw.at("seed"), 2026);
}

TEST(Report, FindsExactMethodsRightAndConsistentOnEverything) {
  std::set<std::string> seen;
  each([&](const std::string& task, const std::string& input, const json& m) {
    const std::string name = m.at("method");
    seen.insert(name);
    EXPECT_GT(m.at("asked"), 0);
    EXPECT_GT(m.at("query_ns"), 0);
    if (kIncomplete.contains(task) && kOfTheCode.contains(name)) return;
    if (!kAlwaysRight.contains(name) && !kNeverWrong.contains(name)) return;
    EXPECT_EQ(m.at("wrong"), 0) << task << ' ' << input << ' ' << name;
    EXPECT_EQ(m.at("inconsistent"), 0) << task << ' ' << input << ' ' << name;
    if (kAlwaysRight.contains(name)) {
      EXPECT_EQ(m.at("unsure"), 0) << task << ' ' << input << ' ' << name;
    }
  });
  EXPECT_THAT(seen, testing::IsSupersetOf(kAlwaysRight));
  EXPECT_THAT(seen, testing::IsSupersetOf(kNeverWrong));
}

TEST(Report, FindsFloatsWrongOnDegenerateInputsAndNotOnHarmlessOnes) {
  each([&](const std::string& task, const std::string& input, const json& m) {
    const std::string name = m.at("method");
    if (name == "double" && input == "degenerate_long" &&
        task != "box-box") {  // whose coordinates are compared as given
      EXPECT_GT(m.at("wrong"), 0) << task;
    }
    if (name == "double" && input == "uniform" && !m.contains("mean_ulps")) {
      EXPECT_EQ(m.at("wrong"), 0) << task;
    }
    if (name == "long-double" && input == "uniform" && m.contains("mean_ulps")) {
      EXPECT_LE(m.at("largest_ulps"), 0x1p40) << task;
    }
    if (name == "float32" && input == "off_by_ulps") {
      EXPECT_GT(m.at("wrong"), 0) << task;
    }
    if (name == "adaptive" && !kUnderflowing.contains(input) && !kIncomplete.contains(task)) {
      EXPECT_EQ(m.at("wrong"), 0) << task << ' ' << input;
    }
    if (name == "rationals") {
      EXPECT_GT(m.at("allocations"), 10) << task << ' ' << input;
    }
    if (name == "double" && !task.starts_with("hull") && !kListing.contains(task)) {
      EXPECT_EQ(m.at("allocations"), 0) << task << ' ' << input;
    }
  });
}

TEST(Report, AsksTheMethodsOfCodeThatBranches) {
  std::map<std::string, std::set<std::string>> methods, at_fault;
  std::map<std::string, int> batches;
  each([&](const std::string& task, const std::string& input, const json& m) {
    const std::string name = m.at("method");
    methods[task].insert(name);
    if (m.at("wrong") != 0) at_fault[name].insert(task);
    if (name == "batch" && task.ends_with("-triangle")) {
      EXPECT_EQ(input, "one_for_all");
      ++batches[task];
    }
  });
  for (const auto& [task, names] : methods) {
    if (kOfMany.contains(task)) continue;
    const bool moves = task.ends_with("-motion"), number = task.ends_with("distance") || task == "smallest-ball";
    EXPECT_TRUE(names.contains("compensated")) << task;
    EXPECT_EQ(names.contains("interval"), !number) << task;
    EXPECT_EQ(names.contains("static-filter"), !number && !moves) << task;
    EXPECT_EQ(names.contains("adaptive"), !number && !moves) << task;
    const bool of_signs = !number && !moves && !kIncomplete.contains(task);
    const bool divides = task == "convex-convex";  // which the integers of a plan do not
    EXPECT_EQ(names.contains("plan"), of_signs && !divides) << task;
    EXPECT_EQ(names.contains("integers") && names.contains("rationals"), !moves) << task;
    EXPECT_EQ(names.contains("advancement"), moves) << task;
  }
  EXPECT_EQ(batches, (std::map<std::string, int>{{"ray-triangle", 1}, {"segment-triangle", 1}}));
  EXPECT_TRUE(at_fault["rationals"].contains("ray-triangle"));  // within the plane: no number mends the code
  EXPECT_EQ(at_fault["rationals"], at_fault["integers"]);
  for (const char* exact : {"exact", "batch"}) EXPECT_THAT(at_fault[exact], testing::IsEmpty()) << exact;
}

TEST(Report, CountsWhatIsMissedOrFarOff) {
  std::map<std::string, std::set<std::string>> methods;
  std::map<std::string, std::uint64_t> of_floats;
  for (const json& trial : report().raw.at("trials")) {
    const std::string task = trial.at("task");
    EXPECT_EQ(trial.contains("tallies"), kOfMany.contains(task)) << task;
    if (!trial.contains("tallies")) continue;
    const json& tallies = trial.at("tallies");
    for (const json& tally : tallies) {
      const std::string counted = tally.at("tally");
      EXPECT_THAT(report().table, HasSubstr("  " + counted + ": " + std::string(tally.at("about"))));
      EXPECT_THAT(report().page, HasSubstr(">" + counted + "</th>"));
    }
    for (const json& m : trial.at("methods")) {
      const std::string name = m.at("method");
      methods[task].insert(name);
      ASSERT_EQ(m.at("tallied").size(), tallies.size());
      for (const std::uint64_t counted : m.at("tallied")) {
        if (kAlwaysRight.contains(name)) {
          EXPECT_EQ(counted, 0U) << task << ' ' << name;
        }
        if (name == "float32") of_floats[task] += counted;
      }
    }
  }
  EXPECT_EQ(methods.size(), kOfMany.size());
  for (const auto& [task, names] : methods) {
    EXPECT_THAT(names, testing::IsSupersetOf({"float32", "double", "exact"})) << task;
    EXPECT_EQ(names.contains("batch"), task.starts_with("closest-") || task == "nearest-point") << task;
  }
  for (const char* task :
       {"mesh-pairs", "closest-point-on-mesh", "box-pairs", "nearest-point", "grid-walk", "triangulation", "welding"})
    EXPECT_GT(of_floats[task], 0U) << task;
}

TEST(Report, SaysWhoLosesVerticesAndWhoseResultHangsOnTheOrder) {
  const auto row = [](const std::string& task, const std::string& input, const std::string& method) {
    json found;
    each([&](const std::string& t, const std::string& i, const json& m) {
      if (t == task && i == input && m.at("method") == method) found = m;
    });
    return found;
  };
  const auto all_wrong = [&](const std::string& task, const std::string& input, const std::string& method) {
    const json m = row(task, input, method);
    return m.at("wrong") == m.at("asked");
  };
  for (const char* ears : {"float32", "double", "absolute", "relative", "long-double"})
    EXPECT_GT(row("triangulation", "bridged_hole", ears).at("tallied")[0], 0) << ears;  // lost
  EXPECT_TRUE(all_wrong("triangulation", "small", "absolute"));
  for (const char* way : {"grid", "hashing", "float32", "first-come"}) EXPECT_TRUE(all_wrong("welding", "chains", way));
  const json first_come = row("welding", "chains", "first-come");
  EXPECT_EQ(first_come.at("inconsistent"), first_come.at("asked"));
  EXPECT_EQ(first_come.at("tallied")[0], 0);  // no pair that is false
}

TEST(Report, IsAPageThatNeedsNothingElse) {
  const std::string& page = report().page;
  EXPECT_THAT(page, AllOf(needs_no_network(), HasSubstr("prefers-color-scheme: dark")));
  const std::string begin = "id=\"raw\">";
  const std::size_t from = page.find(begin) + begin.size();
  EXPECT_EQ(json::parse(page.substr(from, page.find("</script>", from) - from)), report().raw);
}

TEST(Report, IsAPageWhoseFilterWorksInABrowser) {
  if (!has_browser()) return;
  const std::string& page = report().page;
  const Outcome o = in_browser(page, R"(
    const shown = selector => all(selector).filter(e => e.getClientRects().length > 0).length;
    const counts = () => [shown('.marker[data-key="double"]'), shown('article[data-task]'), shown('section[id]'),
                          shown('.marker.gone'), shown('.summary tr'), shown('.summary td')];
    const steps = () => all('.frontier').map(p => p.getAttribute('d')).join();
    const click = (kind, value) => document.querySelector(`input[data-filter="${kind}"][value="${value}"]`).click();
    all('details.fold').forEach(fold => { fold.open = true; });
    const result = [counts()], first = steps();
    click('method', 'double');
    click('class', 'uniform');
    click('task', 'orient2d');
    result.push(counts());
    click('method', 'exact');
    click('method', 'plan');
    click('method', 'batch');
    result.push(steps() !== first);
    document.querySelector('button[data-set="none"]').click();
    result.push(shown('section[id]'));
    document.querySelector('button[data-set="all"]').click();
    click('class', 'uniform');
    for (const m of ['double', 'exact', 'plan', 'batch']) click('method', m);
    result.push(counts(), steps() === first);
    const marker = document.querySelector('.marker[data-key="float32"]'), hint = document.getElementById('hint');
    marker.focus();
    result.push(document.activeElement === marker && !hint.hidden && hint.textContent.startsWith('float32: '));
    document.dispatchEvent(new KeyboardEvent('keydown', {key: 'Escape'}));
    result.push(hint.hidden);
    document.body.replaceChildren(JSON.stringify(result));)");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.err, Not(HasSubstr("CONSOLE")));
  const std::size_t charts = report().raw.at("trials").size();
  const std::size_t fewer = charts - trials_with("class", "uniform") - trials_with("task", "orient2d") + 1;
  const std::size_t rows = tasks() + 1, columns = methods();
  const std::string expected = json{{doubles(), charts, tasks(), 0, rows, tasks() * columns},
                                    {0, fewer, tasks() - 1, 0, rows - 1, (tasks() - 1) * (columns - 1)},
                                    true,
                                    0,
                                    {doubles(), charts, tasks(), 0, rows, tasks() * columns},
                                    true,
                                    true,
                                    true}
                                   .dump();
  EXPECT_THAT(o.out, HasSubstr(expected));
  EXPECT_THAT(in_browser(page, "missing();").err, HasSubstr("CONSOLE"));  // which the first would have shown as well
}

TEST(Report, OpensOnASummaryAndFoldsWhatIsAllRight) {
  const std::string& page = report().page;
  const std::size_t summary = page.find("<h2>Summary</h2>"), first_chart = page.find("<svg");
  ASSERT_NE(summary, std::string::npos);
  EXPECT_LT(summary, page.find("<fieldset"));
  EXPECT_LT(page.find("<fieldset"), first_chart);
  // In each cell the worst share of its task and method; on the page no fold with a wrong answer, no chart without one.
  std::map<std::pair<std::string, std::string>, double> worst;
  each([&](const std::string& task, const std::string&, const json& m) {
    const double share = double(m.at("wrong")) / double(m.at("asked"));
    double& most = worst[{task, m.at("method")}];
    most = std::max(most, share);
  });
  const std::string table = page.substr(summary, first_chart - summary);
  for (const auto& [cell, share] : worst) {
    const std::size_t row = table.find("<tr data-task=\"" + cell.first + "\"");
    ASSERT_NE(row, std::string::npos) << cell.first;
    const std::size_t at = table.find("<td data-key=\"" + cell.second + "\"", row);
    ASSERT_LT(at, table.find("</tr>", row)) << cell.first << ' ' << cell.second;
    const std::string text = table.substr(at, table.find("</td>", at) - at);
    EXPECT_EQ(text.find("class=\"fails\"") != std::string::npos, share > 0) << text;
    EXPECT_EQ(text.find("never wrong") != std::string::npos, share == 0) << text;
    EXPECT_THAT(text, testing::ContainsRegex("<small>[0-9.,]+</small>"));  // without powers of ten
  }
  for (const json& trial : report().raw.at("trials")) {
    const bool right = std::ranges::all_of(
        trial.at("methods"), [](const json& m) { return m.at("wrong") == 0 && m.at("inconsistent") == 0; });
    const std::string task = trial.at("task"), input = trial.at("class");
    const std::size_t at = page.find("<article data-task=\"" + task + "\" data-class=\"" + input + "\"");
    const std::size_t fold = page.find("<details class=\"fold\"", page.find("<section id=\"" + task + "\""));
    EXPECT_EQ(fold < at, right) << task << ' ' << input;
  }
  if (!has_browser()) return;
  const Outcome o = in_browser(page, R"(
    const shown = selector => all(selector).filter(e => e.checkVisibility()).length;
    const folded = all('.fold article').length, unfolded = all('article[data-task]').length - folded;
    const result = [shown('article[data-task]') === unfolded, folded > 0];
    all('.fold').forEach(fold => { fold.open = true; });
    result.push(shown('article[data-task]') === unfolded + folded);
    const table = document.querySelector('.summary'), within = table.parentElement;  // of a window of 1200 pixels
    for (const time of table.querySelectorAll('small')) time.textContent = '1,234';  // long on a machine that is busy
    result.push(within.scrollWidth <= within.clientWidth);
    result.push(document.documentElement.scrollWidth <= window.innerWidth);
    document.body.replaceChildren(JSON.stringify(result));)");
  EXPECT_THAT(o.out, HasSubstr("[true,true,true,true,true]")) << o.err;
}

TEST(Report, HasTheSameAnswersForTheSameSeed) {
  const auto counts = [](const std::string& arguments) {
    const Folder folder;
    run("$PLUMB_LAB chart --quick --task orient3d --class mixture --class near_half --out " + (folder / "r") +
        arguments);
    json all = json::array();
    const json report = json::parse(content(folder / "r/chart.json"));
    EXPECT_EQ(report.at("trials").size(), 2U);
    for (const json& trial : report.at("trials")) {
      for (const json& m : trial.at("methods"))
        all.push_back({trial.at("class"), m.at("method"), m.at("wrong"), m.at("unsure"), m.at("inconsistent")});
    }
    return all;
  };
  const json first = counts("");
  EXPECT_EQ(first, counts(" --seed 2026"));
  EXPECT_NE(first, counts(" --seed 7"));
}

TEST(Frontier, HoldsWhatNoOtherPointBeatsInBoth) {
  const std::vector<ChartPoint> points{{"slow", 9, 0},   {"fast", 1, 0.5}, {"beaten", 2, 0.6},      {"between", 3, 0.1},
                                       {"twin", 3, 0.1}, {"late", 10, 0},  {"faint", 0.5, 0, false}};
  EXPECT_THAT(frontier_of(points), testing::ElementsAre(1, 3, 0));
  EXPECT_THAT(frontier_of({}), testing::IsEmpty());
}

TEST(ChartCommand, RefusesWhatDoesNotExistAndWhatCannotBeWritten) {
  const Outcome task = run("$PLUMB_LAB chart --quick --task orient4d");
  EXPECT_EQ(task.code, 2);
  EXPECT_THAT(task.err, AllOf(HasSubstr("no task orient4d"), HasSubstr("orient3d")));
  const Outcome input = run("$PLUMB_LAB chart --quick --class odd");
  EXPECT_EQ(input.code, 2);
  EXPECT_THAT(input.err, AllOf(HasSubstr("no class odd"), HasSubstr("near_half")));
  EXPECT_EQ(run("$PLUMB_LAB chart --quick --seed -1").code, 2);
  EXPECT_EQ(run("$PLUMB_LAB chart MESH").code, 2);
  for (const std::string folder : {"/no/such/folder", "/proc/folder", "/dev/null"}) {
    const Outcome o = run("$PLUMB_LAB chart --out " + folder);  // in full: it must not begin
    EXPECT_EQ(o.code, 2) << folder;
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb-lab: "), HasSubstr(folder), testing::EndsWith("\n"))) << folder;
    EXPECT_EQ(std::ranges::count(o.err, '\n'), 1) << o.err;
    EXPECT_EQ(o.out, "");
  }
}

TEST(ChartCommand, LeavesAnOlderReportWholeWhereItCannotBeReplaced) {
  const Folder folder;
  std::filesystem::create_directories(folder / "r/chart.json");  // a folder in the way of a file
  const Outcome o = run("$PLUMB_LAB chart --quick --task orient2d --class grid --out " + (folder / "r"));
  EXPECT_EQ(o.code, 2);
  EXPECT_THAT(o.err, HasSubstr("chart.json"));
  for (const auto& entry : std::filesystem::directory_iterator(folder / "r")) {
    EXPECT_THAT(entry.path().string(), Not(HasSubstr(".part")));
  }
}

}  // namespace
}  // namespace plumb::lab
