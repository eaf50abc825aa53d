// Does the table of docs/predicates.md say of every predicate what the catalog and the help say?  What CGAL has alike,
// its last column, is said by the page alone.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "certify/catalog.hpp"
#include "tool/manual/meanings.hpp"

namespace plumb::tool {
namespace {

// "a b", or "a.xy b.xy c" where some have several coordinates.
std::string arguments_of(const CatalogEntry& e) {
  std::string text;
  for (std::size_t i = 0; i < e.arguments.size(); ++i) {
    const auto count = static_cast<std::size_t>(e.arguments[i]);
    text += fmt::format("{}{:c}", i == 0 ? "" : " ", 'a' + static_cast<int>(i));
    if (count > 1)
      text += count <= e.axes.size() ? fmt::format(".{}", e.axes.substr(0, count)) : fmt::format("[{}]", count);
  }
  return text;
}

// A or B for the filter, then the stages that follow it in the chain.
std::string stages_of(const CatalogEntry& e) {
  std::string text(1, e.filter_is_magnitude ? 'A' : 'B');
  for (std::size_t i = 1; i < e.asks.size(); ++i) {
    if (e.asks[i]) text += fmt::format(", {}", stage_names[i]);
  }
  return text;
}

// A bar would end the column.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) out.append(c == '|' ? "\\|" : std::string(1, c));
  return out;
}

std::string row_of(const CatalogEntry& e) {
  const std::string degree = fmt::format("{}{}", e.homogeneous ? "" : "up to ", e.degree);
  return fmt::format("| `{}` | {} | {} | {} | {:.2f} | {} |", e.name, arguments_of(e), escaped(meaning_of(e.name)),
                     degree, e.filter_constant * 0x1p53, stages_of(e));
}

// Rows of the page by the name in their first column.
std::map<std::string, std::string> rows_of_page() {
  std::map<std::string, std::string> rows;
  std::ifstream page(PLUMB_SOURCE_DIR "/docs/predicates.md");
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("| `")) rows[line.substr(3, line.find('`', 3) - 3)] = line;
  }
  return rows;
}

TEST(PredicateTable, HasEveryPredicateAndNoOther) {
  std::map<std::string, std::string> rows = rows_of_page();
  std::string wrong;
  for (const CatalogEntry& e : catalog()) {
    EXPECT_FALSE(meaning_of(e.name).empty()) << e.name << " lacks a sentence in src/tool/manual/meanings.cpp";
    const std::string should = row_of(e);
    const std::string row = rows[std::string(e.name)];
    const bool says_of_cgal = row.size() > should.size() + 4;
    if (!row.starts_with(should) || !says_of_cgal) wrong += should + " CGAL's like or none |\n";
    rows.erase(std::string(e.name));
  }
  EXPECT_EQ(wrong, "") << "docs/predicates.md should hold these rows";
  for (const auto& [name, row] : rows)
    ADD_FAILURE() << "docs/predicates.md tells of " << name << ", which is no predicate";
}

}  // namespace
}  // namespace plumb::tool
