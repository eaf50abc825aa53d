// Which rows of numbers does a text hold?  CSV: decimals in lines, as tables and lists of points are kept.
//
//   min x,min y,max x,max y      a header, which may be missing
//   0.5,0.5,1,1                  blanks, tabs or semicolons may stand for the commas
//
// Laws: (1) passed over are empty lines, what follows '#', a byte order mark and a header: a first line whose words all
// begin with a letter, a quote or '_', and are no number in quotes, "nan" or "inf".  (2) A decimal stands for its
// nearest double, and it is told whether that is it.  (3) Other words throw Error, which quotes them and names the line;
// so does a line with both commas and semicolons, which as a rule has decimal commas.
// Source: RFC 4180; numbers are never quoted.
// Cost: some 100 ns a number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/surface/file/decimal.hpp"

namespace plumb::tool {

struct DecimalRow {
  std::uint64_t line = 0;  // from 1
  std::vector<std::string_view> words;
  std::vector<double> values;
  bool exact = true;  // no decimal of it was moved
};

/// One row after the other of a text that outlives it.
class DecimalRows {
 public:
  /// `name` is the text's in errors.
  DecimalRows(std::string_view text, std::string name);

  /// To the next row; false where there is none.
  bool next();
  [[nodiscard]] const DecimalRow& row() const { return row_; }
  /// "boxes.csv, line 7"
  [[nodiscard]] std::string place() const;
  /// The line of the header, once there is a row; empty where there is none.
  [[nodiscard]] std::string_view header() const { return header_; }

 private:
  [[nodiscard]] bool is_header() const;

  std::string_view rest_, header_;
  std::string name_;
  DecimalReader reader_;
  DecimalRow row_;
  bool is_first_ = true;
};

}  // namespace plumb::tool
