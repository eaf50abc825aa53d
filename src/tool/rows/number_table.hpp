// Which rows of numbers, all of one length, does a file hold?  A CSV, an array of NumPy, or a mesh to take them from.
//
// Laws: (1) what a file is, its content says, and where that is text its name: one that is a mesh by its ending or its
// content is read as a mesh, all else as CSV; what gzip packed is unpacked first.  (2) All rows are as long as one of the
// lengths asked for, all their numbers are finite, and a header that names them has them in that order
// (tool/rows/column_names.hpp); what is not throws Error, which names the file and the row.
// Source: tool/rows/decimal_rows.hpp, tool/rows/npy.hpp, plumb/surface/file/read_mesh.hpp.
// Cost: that of reading.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tool/mesh/asked_mesh.hpp"

namespace plumb::tool {

/// What a row is, and what the numbers of one in the plane and of one in space are called.
struct RowMeaning {
  std::string_view one, many;  // "a box", "boxes"
  std::span<const std::string_view> plane, space;
  bool is_point = false;  // then a cloud's file (.xyz) will do, where a normal, a color and the like may follow each
};

struct NumberTable {
  std::string name;  // of the file, as it is shown
  std::size_t columns = 0;
  std::vector<double> values;        // row by row
  std::vector<std::uint64_t> lines;  // of each row, where the file is text
  std::size_t inexact = 0;           // rows with decimals that are no doubles

  [[nodiscard]] std::size_t size() const { return columns == 0 ? 0 : values.size() / columns; }
  [[nodiscard]] std::span<const double> operator[](std::size_t row) const {
    return std::span(values).subspan(row * columns, columns);
  }
  /// "boxes.csv, line 7", or "boxes.npy, row 5", which counts from 0.
  [[nodiscard]] std::string place_of(std::size_t row) const;
};

/// Of text; `name` is the file's in errors.
enum class Columns { no_more, more_may_follow };
NumberTable parse_table(std::string_view text, const std::string& name, const RowMeaning& meaning,
                        Columns columns = Columns::no_more);
/// Of the bytes of a NumPy file.
NumberTable table_of_npy(std::string_view bytes, const std::string& name, const RowMeaning& meaning);

/// Rows, or a mesh.
struct TableOrMesh {
  NumberTable table;
  std::optional<AskedMesh> mesh;
};

/// Throws Error for a report that takes the name of such a file, as where the report's own was forgotten.
void require_no_table_name(std::string_view option, const std::optional<std::string>& path);

/// The file, or standard input for "-"; no output may replace what is read.
TableOrMesh read_table_or_mesh(const std::string& file, const RowMeaning& meaning, const ReadOptions& reading,
                               const OutputFiles& outputs);

}  // namespace plumb::tool
