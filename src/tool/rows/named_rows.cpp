#include "tool/rows/named_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "plumb/arith/error.hpp"
#include "tool/mesh/inputs.hpp"
#include "tool/rows/column_names.hpp"
#include "tool/rows/decimal_rows.hpp"
#include "tool/rows/packed_rows.hpp"
#include "tool/terminal/decimal_list.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

void require_as_many(const std::vector<double>& values, const RowShape& shape, const std::string& what) {
  if (values.size() != shape.columns.size())
    throw Error(fmt::format("{}: this has {} numbers; {}", what, values.size(), shape.needs));
}

/// A header of six columns, x, y and z of each of two.
void require_no_others(std::string_view header, const RowShape& shape, const std::string& name) {
  for (const auto& [first, second] : shape.others) {
    std::vector<std::string> columns;
    for (const std::string_view of : {first, second}) {
      for (const char axis : {'x', 'y', 'z'}) columns.push_back(std::string(of) + axis);
    }
    if (!are_column_names(header, {columns.begin(), columns.end()})) continue;
    throw Error(fmt::format("{}: the columns are named '{}', and are not read as '{}'; {} takes them", name,
                            printable(header), fmt::join(shape.columns, ","), shape.taken_by));
  }
}

}  // namespace

NamedRow read_named_row(const std::string& words, const std::string& what, const RowShape& shape) {
  auto [values, exact] = read_decimals(words, what);
  require_as_many(values, shape, what);
  return {words, std::move(values), exact};
}

std::vector<NamedRow> parse_named_rows(std::string_view text, const std::string& name, const RowShape& shape) {
  std::vector<NamedRow> named;
  DecimalRows rows(text, name);
  while (rows.next()) {
    if (named.empty() && !rows.header().empty()) {
      require_column_names(rows.header(), shape.columns, name);
      require_no_others(rows.header(), shape, name);
    }
    const DecimalRow& row = rows.row();
    require_as_many(row.values, shape, rows.place());
    named.push_back({fmt::format("{}", fmt::join(row.words, ",")), row.values, row.exact});
  }
  return named;
}

std::vector<NamedRow> read_named_rows(const std::string& file, const ReadOptions& reading, const RowShape& shape) {
  const std::string bytes = bytes_of_input(file), name = printable(name_of_input(file));
  require_no_archive(name, bytes);
  const std::optional<std::string> unpacked = unpacked_rows(bytes, name, reading);
  return parse_named_rows(unpacked ? *unpacked : bytes, name, shape);
}

}  // namespace plumb::tool
