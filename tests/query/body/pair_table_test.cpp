// Do the table of pairs (query/body/pairs.hpp), what compiles, and the tables of docs/overlap.md say the same?  Is each pair
// held against an oracle?
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>

#include "query/body/pair_types.hpp"

namespace plumb {
namespace {

using pair_cases::oracle_of;
using pair_cases::PairOracle;
using pair_cases::Types;

template <class... As, class... Bs>
Types<As..., Bs...> together(Types<As...>, Types<Bs...>);
using AllFigures = decltype(together(pair_cases::Plane{}, pair_cases::Space{}));

template <class A, class B>
std::string name_of_pair() {
  return std::string(name_of(figure_kind<A>)) + " and " + std::string(name_of(figure_kind<B>)) + " in " +
         std::to_string(figure_dimension<A>) + "D";
}

template <class A, class B>
void expect_as_in_table() {
  constexpr PairMethod method = method_of<A, B>;
  const bool present = method != PairMethod::absent;
  EXPECT_EQ((Relatable<A, B>), present) << name_of_pair<A, B>();
  const bool has_oracle = oracle_of(figure_kind<A>, figure_kind<B>) != PairOracle::none;
  EXPECT_TRUE(!present || has_oracle) << name_of_pair<A, B>();
}

template <class A, class... Bs>
void expect_row(Types<Bs...>) {
  (expect_as_in_table<A, Bs>(), ...);
}
template <class... As>
void expect_all(Types<As...> all) {
  (expect_row<As>(all), ...);
}

TEST(PairTable, SaysWhatCompiles) { expect_all(AllFigures{}); }

template <class... Shapes>
std::set<FigureKind> kinds_of(Types<Shapes...>, int dimension) {
  std::set<FigureKind> kinds;
  (static_cast<void>(figure_dimension<Shapes> == dimension ? static_cast<void>(kinds.insert(figure_kind<Shapes>))
                                                           : static_cast<void>(0)),
   ...);
  return kinds;
}

/// A row of the page: methods from the diagonal on.
std::string row_of(FigureKind kind, const std::set<FigureKind>& kinds, int dimension) {
  std::string row = "| **" + std::string(name_of(kind)) + "** |";
  for (const FigureKind other : kinds) {
    row += other < kind ? " |" : " " + std::string(name_of(pair_method(kind, other, dimension))) + " |";
  }
  return row;
}

std::multiset<std::string> rows_of_page() {
  std::multiset<std::string> rows;
  std::ifstream page(PLUMB_SOURCE_DIR "/docs/overlap.md");
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("| **")) rows.insert(line);
  }
  return rows;
}

TEST(PairTable, IsThatOfThePage) {
  std::multiset<std::string> wanted;
  for (const int dimension : {2, 3}) {
    const auto kinds = kinds_of(AllFigures{}, dimension);
    for (const FigureKind kind : kinds) wanted.insert(row_of(kind, kinds, dimension));
  }
  const auto rows = rows_of_page();
  for (const std::string& row : wanted) EXPECT_TRUE(rows.contains(row)) << "docs/overlap.md lacks\n" << row;
  for (const std::string& row : rows) EXPECT_TRUE(wanted.contains(row)) << "docs/overlap.md has\n" << row;
}

TEST(PairTable, LeavesOutWhatThePageSays) {
  for (std::size_t i = 0; i < figure_kinds; ++i) {
    const auto kind = static_cast<FigureKind>(i);
    const bool plane =
        query::is_one_of(kind, {FigureKind::plane, FigureKind::three_point_plane, FigureKind::halfspace});
    const bool straight = query::is_one_of(kind, {FigureKind::line, FigureKind::ray, FigureKind::segment});
    for (const FigureKind round : {FigureKind::cylinder, FigureKind::cone}) {
      EXPECT_EQ(pair_method(kind, round, 3) != PairMethod::absent, plane || straight || kind == FigureKind::point)
          << name_of(kind);
    }
    for (std::size_t j = 0; j < figure_kinds; ++j) {
      const auto other = static_cast<FigureKind>(j);
      if (query::is_one_of(kind, {FigureKind::cylinder, FigureKind::cone}) ||
          query::is_one_of(other, {FigureKind::cylinder, FigureKind::cone}))
        continue;
      EXPECT_NE(pair_method(kind, other, 3), PairMethod::absent) << name_of(kind) << " and " << name_of(other);
    }
  }
}

}  // namespace
}  // namespace plumb
