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

INSTANTIATE_TEST_SUITE_P(All, Links, testing::ValuesIn(document_paths()),
                         [](const auto& at) { return at.param.stem().string(); });

/// The sections of RTCD that a header names as its source, such as 3.1.6.1.
std::set<std::string> sections_of(const fs::path& header) {
  std::string text;  // the opening comment on one line
  for (const std::string& line : lines_of(header)) {
    if (!line.starts_with("//")) break;
    text += line.substr(2);
  }
  std::set<std::string> sections;
  static const std::regex source(R"(RTCD ((?:[0-9]+(?:\.[0-9]+)*(?:, | and )?)+))"), number(R"([0-9]+(?:\.[0-9]+)*)");
  for (std::sregex_iterator at(text.begin(), text.end(), source), end; at != end; ++at) {
    const std::string list = (*at)[1];
    for (std::sregex_iterator n(list.begin(), list.end(), number); n != end; ++n) sections.insert(n->str());
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

}  // namespace
}  // namespace plumb::docs
