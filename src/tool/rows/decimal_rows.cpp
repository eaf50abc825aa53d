#include "tool/rows/decimal_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "plumb/arith/error.hpp"
#include "surface/file/text_lines.hpp"
#include "tool/terminal/decimal_range.hpp"

namespace plumb::tool {
namespace {

constexpr std::string_view blanks = " \t\r", byte_order_mark = "\xEF\xBB\xBF";

bool is_separator(char c) { return c == ',' || c == ';'; }

/// Between blanks, or one comma or semicolon; nothing between two of these is a word, too.
void split_line(std::string_view line, std::vector<std::string_view>& words) {
  words.clear();
  std::size_t at = line.find_first_not_of(blanks);
  while (at != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(" \t\r,;", at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(blanks, end);
    if (at == std::string_view::npos || !is_separator(line[at])) continue;
    at = line.find_first_not_of(blanks, at + 1);
    if (at == std::string_view::npos) words.emplace_back();
  }
}

/// As names of columns begin; numbers, and what is meant as such, do not.
bool begins_like_a_name(std::string_view word) {
  if (word.empty()) return false;
  const char c = word[0];
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
  const std::string lower = surface::lower_case(word.substr(0, 8));
  const bool quote = c == '"' || c == '\'';
  if (quote && word.find_first_of("0123456789+-.") == 1) return false;  // a number in quotes: told, not passed over
  return (letter || quote || c == '_') && lower != "nan" && lower != "inf" && lower != "infinity";
}

}  // namespace

DecimalRows::DecimalRows(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {
  if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
}

std::string DecimalRows::place() const { return name_ + ", line " + std::to_string(row_.line); }

bool DecimalRows::is_header() const { return std::ranges::all_of(row_.words, begins_like_a_name); }

bool DecimalRows::next() {
  while (!rest_.empty()) {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    line = line.substr(0, line.find('#'));
    split_line(line, row_.words);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++row_.line;
    if (row_.words.empty()) continue;
    if (std::exchange(is_first_, false) && is_header()) {
      header_ = line;
      continue;
    }
    if (line.find(',') != line.npos && line.find(';') != line.npos)
      throw Error(place() +
                  ": commas and semicolons stand in one line; part numbers by one of them, and write 1.5 for 1,5");
    const std::uint64_t inexact = reader_.inexact();
    row_.values.clear();
    for (const std::string_view word : row_.words) {
      if (word.empty())
        throw Error(fmt::format("{}: number {} is missing: nothing stands between two commas or after the last",
                                place(), row_.values.size() + 1));
      row_.values.push_back(read_decimal(reader_, word, [this] { return place(); }));
    }
    row_.exact = reader_.inexact() == inexact;
    return true;
  }
  return false;
}

}  // namespace plumb::tool
