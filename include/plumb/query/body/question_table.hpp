// Which pairs of figures does a question take, and how is each answered?  What the tables of the questions have in
// common; relate's stands in query/body/pairs.hpp.
//
// Laws: (1) one letter a pair: row and column are FigureKind; '-' is no answer, as is a row that
// is not there.
// (2) Where the order of the figures says nothing a pair is named in the order of FigureKind, else first by row.
// (3) tests/query/body/pair_table_test.cpp holds the tables against the compiler and the pages: who adds a pair changes
// one letter here, and the row of the page that the test names.
// Source: RTCD 2.3.
// Cost: none, all of it is constexpr.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <string_view>

#include "plumb/query/body/pairs.hpp"

namespace plumb::query {

enum class PairOrder : unsigned char { either, as_named };

/// Of a question that few kinds are the first figure of.
struct NamedRow {
  FigureKind first;
  std::string_view row;
};
constexpr PairRows rows_named(std::initializer_list<NamedRow> named) {
  PairRows rows;
  rows.fill("");
  for (const auto& [first, row] : named) rows[static_cast<std::size_t>(first)] = row;
  return rows;
}

struct QuestionTable {
  std::string_view name;
  PairOrder order;
  std::string_view letters;  // the first is '-'
  std::array<std::string_view, 8> methods;
  PairRows space, plane;

  /// 0 is no answer.
  [[nodiscard]] constexpr std::size_t number(FigureKind a, FigureKind b, int dimension) const {
    auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    if (order == PairOrder::either && j < i) {
      i = static_cast<std::size_t>(b);
      j = static_cast<std::size_t>(a);
    }
    const PairRows& rows = dimension == 2 ? plane : space;
    const std::string_view& row = rows[i];
    return j < row.size() && row[j] != ' ' ? letters.find(row[j]) : 0;
  }
  [[nodiscard]] constexpr bool answers(FigureKind a, FigureKind b, int dimension) const {
    return number(a, b, dimension) != 0;
  }
  [[nodiscard]] constexpr std::string_view method(FigureKind a, FigureKind b, int dimension) const {
    return methods[number(a, b, dimension)];
  }
};

}  // namespace plumb::query
