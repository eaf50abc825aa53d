// How are rows put in order whose first number is one of few?  Into the places of that number, then each place alone.
//
// Laws: the order is that of `before`, which goes by the first number first; rows that it holds for equal come in any
// order.
// Source: Knuth 1998, 5.2 (distribution counting).
// Cost: linear, and n log n for rows of one first number.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace plumb::surface {

/// first_of(row) is below `numbers`.
template <class Row, class FirstOf, class Before>
void sort_by_first(std::vector<Row>& rows, std::size_t numbers, const FirstOf& first_of, const Before& before) {
  std::vector<std::uint32_t> place(numbers + 1);
  for (const Row& row : rows) ++place[first_of(row) + 1];
  for (std::size_t i = 1; i < place.size(); ++i) place[i] += place[i - 1];
  std::vector<Row> sorted(rows.size());
  for (const Row& row : rows) sorted[place[first_of(row)]++] = row;
  std::uint32_t from = 0;
  for (std::size_t i = 0; i < numbers; from = place[i++])
    if (place[i] - from > 1) std::sort(sorted.begin() + from, sorted.begin() + place[i], before);
  rows = std::move(sorted);
}

}  // namespace plumb::surface
