// What does a text say, line by line and word by word?
//
// Laws: a line ends at \n, \r\n or \r; lines without words are passed over; line numbers count from 1 and name the
// first line of a continued one.  Nothing is copied but continued lines.
// Cost: linear.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "plumb/arith/point.hpp"
#include "plumb/surface/decimal.hpp"
#include "surface/mesh_failure.hpp"

namespace plumb::surface {

std::string lower_case(std::string_view text);

struct TextStyle {
  bool comments = false;       // from # to the end of the line
  bool continuations = false;  // a backslash at the end of a line joins the next one
};

class TextLines {
 public:
  TextLines(std::string_view bytes, std::string_view file, TextStyle style = {}, std::uint64_t first_line = 1);

  bool next_line();               // to the next line that has a word; false at the end
  std::string_view next_token();  // the line's next word, empty when there is none
  std::string_view rest();        // what is left of the line
  [[nodiscard]] std::uint64_t line() const { return line_; }
  [[nodiscard]] std::size_t offset() const { return at_; }  // of the line after this one

  [[noreturn]] void fail(MeshFileProblem problem, const std::string& text) const;

  /// Goes to the next line, or fails: the file ends where `expected` should stand.
  void require_line(const std::string& expected);
  /// The line's next word, or fails: the line ends where `expected` should stand.
  std::string_view require_token(std::string_view expected);

  double coordinate(DecimalReader& decimals, std::string_view name);
  Point3 point(DecimalReader& decimals);
  /// A whole number that is not negative; `name` says of what.
  std::uint64_t count(std::string_view name);
  /// The vertex number, from 0 and below `vertices`, that a word of this line is.
  [[nodiscard]] std::uint32_t index(std::string_view token, std::uint64_t vertices) const;

 private:
  std::string_view physical_line();

  std::string_view bytes_, file_, text_;
  TextStyle style_;
  std::size_t at_ = 0;
  std::uint64_t line_, next_line_;
  std::string joined_;
};

/// Reads all of `text` as a whole number; false when it is something else or too large for 64 bits.
bool read_integer(std::string_view text, std::int64_t& value);

}  // namespace plumb::surface
