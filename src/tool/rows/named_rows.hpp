// Which figures are asked about?  A table with one of them a line, each named by its own words, as points and rays are.
//
//   0.5,0.5,0.5          on a line of its own; blanks may stand for the commas
//
// Laws: those of tool/rows/decimal_rows.hpp: what is passed over, and what is refused with its line;
// and of tool/rows/packed_rows.hpp.  A table whose header names figures of another kind throws Error.  A row of more or fewer numbers than there are columns throws Error.
// Source: none.
// Cost: that of reading the decimals.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/arith/point.hpp"
#include "plumb/surface/file/read_mesh.hpp"

namespace plumb::tool {

struct NamedRow {
  std::string name;  // as given, with commas
  std::vector<double> values;
  bool exact;  // no decimal of it was moved
};

struct RowShape {
  std::span<const std::string_view> columns;
  std::string_view needs;  // "a point has three: X,Y,Z"
  /// What a header calls the two points or vectors of a row that are none of these, and which option takes such a table.
  std::span<const std::array<std::string_view, 2>> others = {};
  std::string_view taken_by = {};
};

inline constexpr std::array<std::string_view, 3> point_columns{"x", "y", "z"};
inline constexpr RowShape point_shape{point_columns, "a point has three: X,Y,Z"};
inline constexpr std::array<std::string_view, 6> ray_columns{"ox", "oy", "oz", "dx", "dy", "dz"};
inline constexpr std::array<std::array<std::string_view, 2>, 5> ends_of_segments{
    {{"a", "b"}, {"0", "1"}, {"1", "2"}, {"from", "to"}, {"start", "end"}}};
inline constexpr RowShape ray_shape{ray_columns, "a ray has six: origin and direction", ends_of_segments, "--segments"};
inline constexpr std::array<std::string_view, 6> segment_columns{"ax", "ay", "az", "bx", "by", "bz"};
inline constexpr std::array<std::array<std::string_view, 2>, 3> parts_of_rays{
    {{"o", "d"}, {"origin", "direction"}, {"origin", "dir"}}};
inline constexpr RowShape segment_shape{segment_columns, "a segment has six: its two ends", parts_of_rays, "--rays"};

/// The row has three numbers.
inline Point3 point_of(const NamedRow& row) { return {row.values[0], row.values[1], row.values[2]}; }

/// "0.5,0.5,0.5"; `what` names it in errors.
NamedRow read_named_row(const std::string& words, const std::string& what, const RowShape& shape);

/// `name` is the text's in errors.
std::vector<NamedRow> parse_named_rows(std::string_view text, const std::string& name, const RowShape& shape);

/// Reads the file, or standard input for "-"; throws Error where it cannot be read.
std::vector<NamedRow> read_named_rows(const std::string& file, const ReadOptions& reading, const RowShape& shape);

}  // namespace plumb::tool
