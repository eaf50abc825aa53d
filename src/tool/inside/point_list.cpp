#include "tool/inside/point_list.hpp"

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

Point3 point_of(const std::vector<double>& x, const std::string& what) {
  if (x.size() != 3) throw Error(fmt::format("{}: this has {} numbers; a point has three: X,Y,Z", what, x.size()));
  return {x[0], x[1], x[2]};
}

}  // namespace

NamedPoint read_point(const std::string& words, const std::string& what) {
  const auto [x, exact] = read_decimals(words, what);
  return {words, point_of(x, what), exact};
}

std::vector<NamedPoint> parse_points(std::string_view text, const std::string& name) {
  constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
  std::vector<NamedPoint> points;
  DecimalRows rows(text, name);
  while (rows.next()) {
    if (points.empty() && !rows.header().empty()) require_column_names(rows.header(), names, name);
    const DecimalRow& row = rows.row();
    points.push_back({fmt::format("{}", fmt::join(row.words, ",")), point_of(row.values, rows.place()), row.exact});
  }
  return points;
}

std::vector<NamedPoint> read_points(const std::string& file, const ReadOptions& reading) {
  const std::string bytes = bytes_of_input(file), name = printable(name_of_input(file));
  require_no_archive(name, bytes);
  const std::optional<std::string> unpacked = unpacked_rows(bytes, name, reading);
  return parse_points(unpacked ? *unpacked : bytes, name);
}

}  // namespace plumb::tool
