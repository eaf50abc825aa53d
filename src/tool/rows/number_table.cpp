#include "tool/rows/number_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "plumb/arith/error.hpp"
#include "surface/text_lines.hpp"
#include "tool/rows/column_names.hpp"
#include "tool/rows/decimal_rows.hpp"
#include "tool/rows/npy.hpp"
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

/// Of a name that ends as tables do.
std::optional<FileKind> kind_by_ending(const std::string& file) {
  const std::string ending = surface::lower_case(std::filesystem::path(file).extension().string());
  if (ending == ".npy") return FileKind::npy;
  if (ending == ".csv" || ending == ".txt" || ending == ".tsv") return FileKind::text;
  return {};
}

/// By what a name ends with; nothing where that leaves it to the content.
std::optional<FileKind> kind_by_name(const std::string& file) {
  if (const auto table = kind_by_ending(file)) return table;
  return file == "-" || why_mesh(file).empty() ? std::nullopt : std::optional(FileKind::mesh);
}

FileKind kind_by_content(std::string_view bytes) {
  const bool packed = bytes.starts_with("\x1f\x8b");
  return is_npy(bytes)                                                    ? FileKind::npy
         : packed || format_by_content(bytes.substr(0, 4096)).has_value() ? FileKind::mesh
                                                                          : FileKind::text;
}

}  // namespace

std::string NumberTable::place_of(std::size_t row) const {
  return lines.empty() ? fmt::format("{}, row {}", name, row) : fmt::format("{}, line {}", name, lines[row]);
}

NumberTable parse_table(std::string_view text, const std::string& name, const RowMeaning& meaning) {
  NumberTable table{name, 0, {}, {}, 0};
  if (text.empty()) throw Error(fmt::format("{}: the file is empty, expected {}, one on a line", name, meaning.many));
  DecimalRows rows(text, name);
  while (rows.next()) {
    const DecimalRow& row = rows.row();
    const std::size_t length = row.values.size();
    if (!is_length(length, meaning))
      throw Error(fmt::format("{}: this has {}; {}", rows.place(),
                              length == 1 ? "1 number" : fmt::format("{} numbers", length), expected(meaning)));
    if (table.columns != 0 && length != table.columns)
      throw Error(fmt::format("{}: this has {} numbers, and line {} has {}; a file holds {} in the plane or in space",
                              rows.place(), length, table.lines.front(), table.columns, meaning.many));
    if (table.columns == 0 && !rows.header().empty())
      require_column_names(rows.header(), names_of(length, meaning), name);
    table.columns = length;
    table.values.insert(table.values.end(), row.values.begin(), row.values.end());
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
  if (surface::lower_case(std::filesystem::path(file).extension().string()) == ".npz")
    throw Error(fmt::format("{}: this is an archive of NumPy's arrays (.npz); write the one of {} by numpy.save",
                            printable(name), meaning.many));
  TableOrMesh read;
  std::string bytes;
  if (named != FileKind::mesh) bytes = bytes_of_input(file);
  const FileKind kind = is_npy(bytes) ? FileKind::npy : named.value_or(kind_by_content(bytes));
  if (kind == FileKind::npy) {
    read.table = table_of_npy(bytes, printable(name), meaning);
  } else if (kind == FileKind::text) {
    read.table = parse_table(bytes, printable(name), meaning);
  } else {
    LoadReport load;
    const PolygonMesh polygons =
        bytes.empty() ? read_input(file, &load, reading) : parse_input(bytes, name, &load, reading);
    read.mesh = asked_mesh(name, polygons, std::move(load), outputs);
  }
  return read;
}

}  // namespace plumb::tool
