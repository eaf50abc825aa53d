// Does everything that README.md and docs/*.md point to exist, and does docs/sections.md agree with the headers?
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "docs/markdown.hpp"

namespace plumb::docs {
namespace {

const fs::path tree = PLUMB_SOURCE_DIR;

class Links : public testing::TestWithParam<fs::path> {};

TEST_P(Links, LeadToFiles) {
  const Document document = read_document(GetParam());
  for (const Link& link : document.links) {
    if (link.target.find("://") != std::string::npos) continue;
    const std::size_t hash = link.target.find('#');
    const std::string file = link.target.substr(0, hash);
    const fs::path path = file.empty() ? document.path : document.path.parent_path() / file;
    EXPECT_TRUE(fs::exists(path)) << document.path.string() << ":" << link.line << ": " << link.target;
    if (hash != std::string::npos && fs::exists(path)) {
      const std::vector<std::string> anchors = read_document(path).anchors;
      EXPECT_NE(std::ranges::find(anchors, link.target.substr(hash + 1)), anchors.end())
          << document.path.string() << ":" << link.line << ": " << link.target;
    }
  }
}

// `tests/docs/links_test.cpp` names a file of the tree; `tests/<folder>/` and `src/*.cpp` name none.
TEST_P(Links, NamesOfFilesAreTrue) {
  const std::set<std::string> tops{"include", "src", "predicates", "tests", "fuzz", "docs", ".ci"};
  const Document document = read_document(GetParam());
  for (const Link& name : document.mentions) {
    const std::string& path = name.target;
    if (path.find('/') == path.npos || path.find_first_of(" <>*{(") != path.npos) continue;
    if (!tops.contains(path.substr(0, path.find('/')))) continue;
    EXPECT_TRUE(fs::exists(tree / path)) << document.path.string() << ":" << name.line << ": " << path;
  }
}

// `surface/topology/shells.hpp`, `plumb/arith/point.hpp`: as includes have them, or beside include/plumb/.
TEST_P(Links, NamesOfHeadersAreTrue) {
  const std::set<std::string> folders{"plumb", "arith",   "certify", "degenerate", "figure", "query",
                                      "space", "surface", "world",   "tool",       "lab"};
  const Document document = read_document(GetParam());
  for (const Link& name : document.mentions) {
    const std::string& path = name.target;
    if (!path.ends_with(".hpp") || path.find_first_of(" <>*{(") != path.npos) continue;
    if (path.find('/') == path.npos || !folders.contains(path.substr(0, path.find('/')))) continue;
    EXPECT_TRUE(fs::exists(tree / "include" / path) || fs::exists(tree / "include/plumb" / path) ||
                fs::exists(tree / "src" / path) || fs::exists(tree / "tests" / path))
        << document.path.string() << ":" << name.line << ": " << path;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Links, testing::ValuesIn(document_paths()),
                         [](const auto& at) { return at.param.stem().string(); });

/// The sections of RTCD that a header names as its source: "RTCD 5.3, 5.3.1 to 5.3.8; 6 (figure 6.2)", up to a period
/// or to what it costs.  No chapter has a number above 13.
std::set<std::string> sections_of(const fs::path& header) {
  std::string text;  // the opening comment on one line
  for (const std::string& line : lines_of(header)) {
    if (!line.starts_with("//")) break;
    text += line.substr(2);
  }
  const std::string remark = R"(\((?![^()]*RTCD)[^()]*\))", source = R"(RTCD ([0-9](?:[^.)]|\.(?=[^ ]))*))",
                    cost = "[Cc]ost.*", figure = R"((figure|table)s? [0-9.]+((, | and | to )[0-9.]+)*)",
                    item = R"(([0-9]+(?:\.[0-9]+)*)(?: to ([0-9]+(?:\.[0-9]+)*))?)";
  std::set<std::string> sections;
  for (const Match& named : matches_of(without_matches(text, remark), source)) {
    for (const auto& [whole, first, last] :
         matches_of(without_matches(without_matches(named.first, cost), figure), item)) {
      if (first.find('.') == first.npos && std::stoul(first) > 13) continue;  // a year
      sections.insert(first);
      if (last.empty()) continue;
      const std::size_t dot = first.rfind('.') + 1;
      EXPECT_EQ(first.substr(0, dot), last.substr(0, last.rfind('.') + 1)) << header << ": " << whole;
      for (unsigned long k = std::stoul(first.substr(dot)); k <= std::stoul(last.substr(dot)) && k < 100; ++k)
        sections.insert(first.substr(0, dot).append(std::to_string(k)));
    }
  }
  return sections;
}

/// Rows of the table: section -> the rest of its row.
std::map<std::string, std::string> rows_of(const fs::path& path) {
  std::map<std::string, std::string> rows;
  for (const std::string& line : lines_of(path)) {
    std::istringstream words(line);
    std::string bar, section;
    words >> bar >> section;
    if (bar == "|") rows[section] += line;
  }
  return rows;
}

TEST(Sections, ListEveryHeaderUnderTheSectionsItNames) {
  const std::map<std::string, std::string> rows = rows_of(tree / "docs/sections.md");
  std::size_t headers = 0;
  for (const char* top : {"include/plumb", "predicates"}) {
    for (const auto& entry : fs::recursive_directory_iterator(tree / top)) {
      if (entry.path().extension() != ".hpp") continue;
      const std::string header = '`' + fs::relative(entry.path(), tree).generic_string() + '`';
      for (const std::string& section : sections_of(entry.path())) {
        ++headers;
        const auto row = rows.find(section);
        ASSERT_NE(row, rows.end()) << header << " names section " << section << ", which has no row";
        EXPECT_NE(row->second.find(header), std::string::npos) << section << " lacks " << header;
      }
    }
  }
  EXPECT_GE(headers, 20u);
}

TEST(Sections, NameOnlyHeadersThatNameThem) {
  const std::string name = R"(`((?:include|predicates)/[^`]*\.hpp)`)";
  std::size_t headers = 0;
  for (const auto& [section, row] : rows_of(tree / "docs/sections.md")) {
    for (const Match& match : matches_of(row, name)) {
      const fs::path header = match.first;
      ++headers;
      EXPECT_TRUE(sections_of(tree / header).contains(section)) << header << " does not name " << section;
    }
  }
  EXPECT_GE(headers, 100u);
}

}  // namespace
}  // namespace plumb::docs
