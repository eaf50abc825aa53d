#include "tool/rows/number_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "plumb/arith/error.hpp"
#include "surface/file/foreign_formats.hpp"
#include "surface/file/text_lines.hpp"
#include "tool/rows/column_names.hpp"
#include "tool/rows/decimal_rows.hpp"
#include "tool/rows/npy.hpp"
#include "tool/rows/packed_rows.hpp"
#include "tool/terminal/mesh_name.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

/// "a box has 4 (min x, min y, max x, max y) or 6 (min x, ...)"
std::string expected(const RowMeaning& meaning) {
  return fmt::format("{} has {} ({}) or {} ({})", meaning.one, meaning.plane.size(), fmt::join(meaning.plane, ", "),
                     meaning.space.size(), fmt::join(meaning.space, ", "));
}

bool is_length(std::size_t length, const RowMeaning& meaning) {
  return length == meaning.plane.size() || length == meaning.space.size();
}

std::span<const std::string_view> names_of(std::size_t length, const RowMeaning& meaning) {
  return length == meaning.plane.size() ? meaning.plane : meaning.space;
}

void require_finite(const NumberTable& table, const RowMeaning& meaning) {
  for (std::size_t i = 0; i < table.values.size(); ++i) {
    const double x = table.values[i];
    if (x - x == 0) continue;
    throw Error(fmt::format("{}: {} is {}, not a real number; give a finite one", table.place_of(i / table.columns),
                            names_of(table.columns, meaning)[i % table.columns], x));
  }
}

enum class FileKind : unsigned char { text, npy, mesh };

std::string ending_within(const std::string& file) {
  return surface::lower_case(std::filesystem::path(name_within(file)).extension().string());
}

/// Of a name that ends as tables do, packed or not.
std::optional<FileKind> kind_by_ending(const std::string& file) {
  const std::string ending = ending_within(file);
  if (ending == ".npy") return FileKind::npy;
  if (ending == ".csv" || ending == ".txt" || ending == ".tsv" || ending == ".xyz") return FileKind::text;
  return {};
}

/// By what a name ends with; nothing where that leaves it to the content.
std::optional<FileKind> kind_by_name(const std::string& file) {
  if (const auto table = kind_by_ending(file)) return table;
  return file != "-" && is_mesh_name(file) ? std::optional(FileKind::mesh) : std::nullopt;
}

FileKind kind_by_content(std::string_view bytes) {
  if (is_npy(bytes)) return FileKind::npy;
  return format_by_content(bytes) || surface::foreign_by_content(bytes) ? FileKind::mesh : FileKind::text;
}

}  // namespace

std::string NumberTable::place_of(std::size_t row) const {
  return lines.empty() ? fmt::format("{}, row {}", name, row) : fmt::format("{}, line {}", name, lines[row]);
}

NumberTable parse_table(std::string_view text, const std::string& name, const RowMeaning& meaning, Columns columns) {
  NumberTable table{name, 0, {}, {}, 0};
  if (text.empty()) throw Error(fmt::format("{}: the file is empty, expected {}, one on a line", name, meaning.many));
  DecimalRows rows(text, name);
  while (rows.next()) {
    const DecimalRow& row = rows.row();
    const std::size_t length =
        columns == Columns::more_may_follow ? std::min(row.values.size(), meaning.space.size()) : row.values.size();
    if (!is_length(length, meaning))
      throw Error(fmt::format("{}: this has {}; {}", rows.place(),
                              length == 1 ? "1 number" : fmt::format("{} numbers", length), expected(meaning)));
    if (table.columns != 0 && length != table.columns)
      throw Error(fmt::format("{}: this has {} numbers, and line {} has {}; a file holds {} in the plane or in space",
                              rows.place(), length, table.lines.front(), table.columns, meaning.many));
    if (table.columns == 0 && !rows.header().empty())
      require_column_names(rows.header(), names_of(length, meaning), name);
    table.columns = length;
    table.values.insert(table.values.end(), row.values.begin(),
                        row.values.begin() + static_cast<std::ptrdiff_t>(length));
    table.lines.push_back(row.line);
    table.inexact += row.exact ? 0 : 1;
  }
  if (table.columns == 0)
    throw Error(fmt::format("{}: there is no row of numbers in it, expected {}, one on a line", name, meaning.many));
  return table;
}

NumberTable table_of_npy(std::string_view bytes, const std::string& name, const RowMeaning& meaning) {
  NpyArray array = read_npy(bytes, name);
  if (array.shape.size() != 2 || !is_length(array.shape[1], meaning))
    throw Error(fmt::format("{}: the array has the shape {}; expected a row for each of the {}, and {}", name,
                            shape_text(array.shape), meaning.many, expected(meaning)));
  NumberTable table{name, array.shape[1], std::move(array.values), {}, 0};
  require_finite(table, meaning);
  return table;
}

void require_no_table_name(std::string_view option, const std::optional<std::string>& path) {
  if (!path || kind_by_ending(*path) == std::nullopt) return;
  throw Error(
      fmt::format("{0} takes the name of the file to write, and {1} is that of a table, which is kept; write "
                  "'{0} REPORT {1}', or '{0} - {1}' for standard output",
                  option, printable(*path)));
}

TableOrMesh read_table_or_mesh(const std::string& file, const RowMeaning& meaning, const ReadOptions& reading,
                               const OutputFiles& outputs) {
  const std::string name = name_of_input(file);
  const std::optional<FileKind> named = kind_by_name(file);
  if (named != FileKind::mesh) require_no_archive(file, "");
  TableOrMesh read;
  std::string bytes;
  if (named != FileKind::mesh) bytes = bytes_of_input(file);
  const std::optional<std::string> unpacked = unpacked_rows(bytes, printable(name), reading);
  const std::string_view rows = unpacked ? std::string_view(*unpacked) : bytes;
  if (named && named != FileKind::mesh) require_no_archive(name, rows);
  const FileKind kind = is_npy(rows) ? FileKind::npy : named.value_or(kind_by_content(rows));
  if (kind == FileKind::npy) {
    read.table = table_of_npy(rows, printable(name), meaning);
  } else if (kind == FileKind::text) {
    const bool more_follow = meaning.is_point && ending_within(file) == ".xyz";
    read.table = parse_table(rows, printable(name), meaning, more_follow ? Columns::more_may_follow : Columns::no_more);
  } else {
    LoadReport load;
    std::error_code ignored;  // a pipe is read once, a file also with those beside it
    const bool by_name = bytes.empty() || (file != "-" && std::filesystem::is_regular_file(file, ignored));
    const PolygonMesh polygons = by_name ? read_input(file, &load, reading) : parse_input(bytes, name, &load, reading);
    read.mesh = asked_mesh(name, polygons, std::move(load), outputs);
  }
  return read;
}

}  // namespace plumb::tool
