// What does a text say, line by line and word by word?
//
// Laws: a line ends at \n, \r\n or \r; lines without words are passed over; line numbers count from 1 and name the
// first line of a continued one.  Nothing is copied but continued lines.  Where words flow, they may stand on any lines;
// what is found wrong then is told together with the first line that was not as long as what should stand on it, for a
// number that is missing there is noticed only further down.
// Cost: linear.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "plumb/arith/point.hpp"
#include "plumb/surface/file/decimal.hpp"
#include "surface/file/mesh_failure.hpp"

namespace plumb::surface {

std::string lower_case(std::string_view text);
/// Is it this word, whose letters are small, in letters of any size?
bool is_word(std::string_view text, std::string_view word);

struct TextStyle {
  bool comments = false;       // from # to the end of the line
  bool continuations = false;  // a backslash at the end of a line joins the next one
  bool flowing = false;        // the next word may stand on a later line
};

class TextLines {
 public:
  TextLines(std::string_view bytes, std::string_view file, TextStyle style = {}, std::uint64_t first_line = 1);

  bool next_line();               // to the next line that has a word; false at the end
  std::string_view next_token();  // the line's next word, or where words flow the text's; empty when there is none
  std::string_view rest();        // what is left of the line
  bool at_line_end();             // no word is left on the line
  /// The words that are left on the line, from the first to the last.
  struct Words {
    std::string_view text{};
    std::size_t count = 0;
    bool numbers = true;  // they look like numbers
  };
  Words words_left();
  /// `text` is what one would say of this line if words did not flow; kept, of the first, for fail().
  void note_odd_line(const std::string& text);
  [[nodiscard]] bool has_odd_line() const { return odd_.has_value(); }
  /// Joined of several by backslashes.
  [[nodiscard]] bool is_joined() const { return is_joined_; }
  void set_flowing(bool flowing) { style_.flowing = flowing; }
  [[nodiscard]] std::uint64_t line() const { return line_; }
  [[nodiscard]] std::size_t offset() const { return at_; }  // of the line after this one

  [[noreturn]] void fail(MeshFileProblem problem, const std::string& text) const;

  /// Fails: the file ends where `expected` should stand.
  [[noreturn]] void fail_at_end(std::string_view expected) const;
  /// Goes to the next line, or fails as that does.
  void require_line(std::string_view expected);
  /// The line's next word, or fails: the line ends where `expected` should stand, or where words flow the file.
  std::string_view require_token(std::string_view expected);

  double coordinate(DecimalReader& decimals, std::string_view name);
  Point3 point(DecimalReader& decimals);
  /// A whole number that is not negative; `name` says of what.
  std::uint64_t count(std::string_view name);
  /// The vertex number, from 0 and below `vertices`, that a word of this line is.
  [[nodiscard]] std::uint32_t index(std::string_view token, std::uint64_t vertices) const;

 private:
  struct OddLine {
    std::uint64_t line;
    std::string text;
  };
  std::string_view physical_line();
  std::string_view token_on_line();

  std::string_view bytes_, file_, text_;
  TextStyle style_;
  std::size_t at_ = 0;
  std::uint64_t line_, next_line_;
  std::string joined_;
  bool is_joined_ = false;
  std::optional<OddLine> odd_;
};

/// Do words like this stand for numbers?  By their characters alone.
bool looks_like_a_number(std::string_view word);

/// Reads all of `text` as a whole number; false when it is something else or too large for 64 bits.
bool read_integer(std::string_view text, std::int64_t& value);

}  // namespace plumb::surface
