// `plumb-lab stability` as a user meets it: what is written and refused, and that its page works.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "lab/quick_report.hpp"
#include "lab/stability/command.hpp"
#include "tool/browser.hpp"

namespace plumb::lab {
namespace {

const QuickReport& report() {
  static const QuickReport once("stability");
  return once;
}

std::size_t scenes_of(const std::string& experiment) {
  return static_cast<std::size_t>(std::ranges::count_if(
      report().raw.at("scenes"), [&](const json& s) { return s.at("experiment") == experiment; }));
}
std::set<std::string> experiments() {
  std::set<std::string> names;
  for (const json& scene : report().raw.at("scenes")) names.insert(scene.at("experiment"));
  return names;
}

TEST(Laboratory, WritesEveryTableAndPicture) {
  EXPECT_EQ(report().outcome.code, 0) << report().outcome.err;
  EXPECT_EQ(report().outcome.err, "");
  EXPECT_THAT(report().outcome.out, StartsWith(report().table));
  std::set<std::string> files{"stability.txt", "stability.json", "stability.html"};
  for (const json& scene : report().raw.at("scenes")) {
    EXPECT_THAT(report().table,
                HasSubstr(std::string(scene.at("experiment")) + ": " + std::string(scene.at("scene")) + ": "));
    for (const json& picture : scene.at("pictures")) {
      const std::string file = picture.at("picture");
      EXPECT_TRUE(files.insert(file).second) << file;
      EXPECT_THAT(report().file(file), StartsWith("<svg"));
    }
  }
  files.insert(".plumb-stability-files");
  std::set<std::string> written;
  for (const auto& entry : std::filesystem::directory_iterator(report().folder())) {
    written.insert(entry.path().filename());
  }
  EXPECT_EQ(written, files);
  std::set<std::string> known;
  for (const stability::Experiment& e : stability::all_experiments()) known.insert(e.name);
  EXPECT_EQ(experiments(), known);
}

TEST(Laboratory, FindsThatExactMethodsFailNothingAndThatOthersDo) {
  for (const std::string& experiment : experiments()) {
    std::uint64_t others = 0;
    for (const json& scene : report().raw.at("scenes")) {
      bool has_exact = false;
      for (const json& method : scene.at("methods")) {
        has_exact = has_exact || method.at("is_exact");
        for (const json& c : method.at("counts")) {
          if (method.at("is_exact")) {
            EXPECT_EQ(c.at("failures"), 0) << scene.at("scene") << c;
          } else if (scene.at("experiment") == experiment) {
            others += c.at("failures").get<std::uint64_t>();
          }
        }
      }
      EXPECT_TRUE(has_exact) << scene.at("scene");
    }
    EXPECT_GT(others, 0U) << experiment;
  }
}

TEST(Laboratory, IsAPageWhoseFilterWorksInABrowser) {
  const std::string& page = report().page;
  EXPECT_THAT(page, needs_no_network());
  if (!has_browser()) return;
  const Outcome o = in_browser(page, R"(
    const shown = selector => all(selector).filter(e => e.getClientRects().length > 0).length;
    const counts = () => [shown('article'), shown('section'), shown('tr[data-key="double"]') > 0];
    const click = (kind, value) => document.querySelector(`input[data-filter="${kind}"][value="${value}"]`).click();
    const result = [counts()];
    click('experiment', 'grid');
    click('method', 'double');
    result.push(counts());
    document.querySelector('button[data-set="none"]').click();
    result.push(shown('section'));
    document.querySelector('button[data-set="all"]').click();
    click('method', 'double');
    result.push(counts(), all('image').every(i => i.getBBox().width > 0), all('figure svg').length);
    document.body.replaceChildren(JSON.stringify(result));)");
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_THAT(o.err, Not(HasSubstr("CONSOLE")));
  const std::size_t scenes = report().raw.at("scenes").size(), sections = experiments().size();
  std::size_t pictures = 0;
  for (const json& scene : report().raw.at("scenes")) pictures += scene.at("pictures").size();
  EXPECT_THAT(o.out, HasSubstr(json({{scenes, sections, true},
                                     {scenes - scenes_of("grid"), sections - 1, false},
                                     0,
                                     {scenes, sections, true},
                                     true,
                                     pictures})
                                   .dump()));
}

TEST(LaboratoryCommand, RefusesWhatDoesNotExistAndWhatCannotBeWritten) {
  for (const auto& [arguments, words] : std::vector<std::pair<std::string, std::string>>{
           {"--experiment gird", "no experiment gird (did you mean grid?); there are grid, "},
           {"--out /no/such/folder", "/no/such/folder"},
           {"--out /dev/null", "/dev/null"},
           {"--ccd /no/such/folder", "--ccd /no/such/folder"},
           {"--models /dev/null", "--models /dev/null"},
           {"--seed -1", "--seed"},
           {"MESH", "MESH"}}) {
    const Outcome o = run("$PLUMB_LAB stability " + arguments);  // in full: it must not begin
    EXPECT_EQ(o.code, 2) << arguments;
    EXPECT_EQ(o.out, "");
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb-lab: "), HasSubstr(words))) << arguments;
    EXPECT_EQ(std::ranges::count(o.err, '\n'), 1) << o.err;
  }
}

TEST(LaboratoryCommand, RefusesFoldersThatHoldNoQueriesAndNoMeshes) {
  struct Bad {
    std::string file, text, option, words;
  };
  for (const Bad& bad : std::vector<Bad>{{"q.txt", "", "--ccd", "no queries"},
                                         {"q.csv", "1,2,3\n", "--ccd", "q.csv:1: expected integers"},
                                         {"q.csv", "1,1,9007199254740993,1,1,1,0\n", "--ccd", "q.csv:1: expected"},
                                         {"q.csv", "1,1,2,3,1,1,0\n", "--ccd", "q.csv:1: a denominator is no power"},
                                         {"q.csv", "1,1,1,1,1,1,1\n1,1,1,1,1,1,2\n", "--ccd", "q.csv:2: expected 0"},
                                         {"q.csv", "1,1,1,1,1,1,1\n", "--ccd", "its last query is cut off"},
                                         {"m.txt", "", "--models", "no mesh in this folder"},
                                         {"m.obj", "v 0 0 0\n", "--models", "m.obj: "},
                                         {"m.OFF", "OFF 1 1\n", "--models", "m.OFF:1: "}}) {
    const Folder folder;
    std::ofstream(folder / bad.file) << bad.text;
    const Outcome o = run("$PLUMB_LAB stability " + bad.option + " " + (folder / ""));  // in full: it must not begin
    EXPECT_EQ(o.code, 2) << bad.words;
    EXPECT_EQ(o.out, "");
    EXPECT_THAT(o.err, AllOf(StartsWith("plumb-lab: "), HasSubstr(bad.words))) << bad.words;
    EXPECT_EQ(std::ranges::count(o.err, '\n'), 1) << o.err;
  }
}

TEST(LaboratoryCommand, RunsTheExperimentsThatAreNamedAlone) {
  const Outcome one = run("$PLUMB_LAB stability --quick --experiment sweeps");
  EXPECT_EQ(one.code, 0);
  EXPECT_THAT(one.out, AllOf(StartsWith("sweeps: "), Not(HasSubstr("\ngrid: "))));
  EXPECT_EQ(run("$PLUMB_LAB stability --quick --experiment sweeps --seed 2026").out, one.out);
  EXPECT_NE(run("$PLUMB_LAB stability --quick --experiment sweeps --seed 7").out, one.out);
}

TEST(LaboratoryCommand, ExitsWithOneWhereAnExactMethodFails) {
  using namespace stability;
  const auto experiment = [](std::uint64_t failures) {
    const auto run_scene = [failures] {
      return Findings{
          {{"double", {{"things that broke", 5, 9}}}, {"exact", {{"things that broke", failures, 9}}, true}}, {}};
    };
    const auto scenes = [=](const Settings&) { return std::vector<Scene>{{"a scene", "made up", run_scene}}; };
    return std::vector<Experiment>{{"made-up", "does it break?", "none", scenes}};
  };
  EXPECT_EQ(run_stability({}, experiment(0)), 0);
  EXPECT_EQ(run_stability({}, experiment(1)), 1);
}

}  // namespace
}  // namespace plumb::lab
