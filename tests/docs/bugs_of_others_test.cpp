// Is docs/bugs_of_others.md true?  Each row has a case that asks Plumb, each case a row, and the answers are the page's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <ostream>
#include <set>

#include "docs/bugs_of_others/case.hpp"
#include "docs/markdown.hpp"

namespace plumb::docs {
namespace {

const fs::path page = fs::path(PLUMB_SOURCE_DIR) / "docs/bugs_of_others.md";

/// Headings as in the page, in its order.
std::vector<Kind> kinds() {
  return {{"Crossings and sides", crossing_cases()},
          {"Convex hulls", hull_cases()},
          {"Triangles that meet", triangle_cases()},
          {"Boxes and solids that meet", box_cases()},
          {"Distances, closest points and depths", distance_cases()},
          {"Rays", ray_cases()},
          {"Motion", motion_cases()},
          {"Points in polygons and meshes", inside_cases()},
          {"Smallest circles, areas and convexity", measure_cases()},
          {"Nearest neighbors", tree_cases()},
          {"Files, faces and sections", file_cases()}};
}

struct Row {
  std::string heading, report, address, answer;
  std::size_t line = 0;

  friend std::ostream& operator<<(std::ostream& out, const Row& row) { return out << row.report; }
};

std::string trimmed(const std::string& cell) {
  const std::size_t from = cell.find_first_not_of(" `"), to = cell.find_last_not_of(" `");
  return from == cell.npos ? "" : cell.substr(from, to - from + 1);
}

std::vector<Row> rows() {
  std::vector<Row> rows;
  std::string heading;
  std::size_t line = 0;
  for (const std::string& text : lines_of(page)) {
    ++line;
    if (text.starts_with("## ")) heading = text.substr(3);
    if (!text.starts_with("| [")) continue;
    const std::vector<Match> link = matches_of(text, R"(^\| \[([^\]]+)\]\(([^)]+)\))");
    const std::size_t last = text.rfind(" |"), before = text.rfind(" | ", last - 1);
    const Match found = link.empty() ? Match{} : link[0];
    rows.push_back({heading, found.first, found.second, trimmed(text.substr(before + 3, last - before - 3)), line});
  }
  return rows;
}

TEST(BugsOfOthers, HasAtLeastFortyRowsWithTheirSources) {
  const std::vector<Row> all = rows();
  EXPECT_GE(all.size(), 40u);
  std::set<std::string> seen, projects;
  for (const Row& row : all) {
    const std::size_t hash = row.report.find('#');
    ASSERT_NE(hash, std::string::npos) << page.string() << ":" << row.line;
    const std::string place = "https://github.com/" + row.report.substr(0, hash), number = row.report.substr(hash + 1);
    EXPECT_TRUE(row.address == place + "/issues/" + number || row.address == place + "/pull/" + number)
        << page.string() << ":" << row.line << ": " << row.address;
    EXPECT_TRUE(seen.insert(row.report).second) << page.string() << ":" << row.line << ": " << row.report << " again";
    projects.insert(place);
  }
  const std::string counted = R"(([0-9]+) public reports [^.]* of ([0-9]+) other projects)";
  const std::vector<Match> told = matches_of(text_of(page), counted);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].first, std::to_string(all.size()));
  EXPECT_EQ(told[0].second, std::to_string(projects.size()));
}

TEST(BugsOfOthers, EachRowHasItsCaseAndEachCaseItsRow) {
  std::vector<std::string> in_page, in_tables;
  for (const Row& row : rows()) in_page.push_back(row.heading + ": " + row.report);
  for (const Kind& kind : kinds()) {
    for (const Case& c : kind.cases) in_tables.push_back(std::string(kind.heading) + ": " + std::string(c.report));
  }
  EXPECT_EQ(in_page, in_tables);
}

class Answer : public testing::TestWithParam<Row> {};

TEST_P(Answer, IsThatOfThePage) {
  const Row& row = GetParam();
  for (const Kind& kind : kinds()) {
    for (const Case& c : kind.cases) {
      if (c.report != row.report) continue;
      EXPECT_EQ(c.answer(), row.answer) << page.string() << ":" << row.line;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Answer, testing::ValuesIn(rows()), [](const auto& at) {
  std::string name = at.param.report;
  std::ranges::replace_if(
      name, [](const unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
});

}  // namespace
}  // namespace plumb::docs
