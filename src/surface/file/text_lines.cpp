#include "surface/file/text_lines.hpp"

#include <charconv>

namespace plumb::surface {
namespace {

constexpr bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_sign_of_number(char c) { return c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E'; }

}  // namespace

std::string lower_case(std::string_view text) {
  std::string lower;
  for (const char c : text) lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return lower;
}

bool is_word(std::string_view text, std::string_view word) {
  if (text.size() != word.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if ((text[i] >= 'A' && text[i] <= 'Z' ? text[i] - 'A' + 'a' : text[i]) != word[i]) return false;
  return true;
}

bool looks_like_a_number(std::string_view word) {
  bool digit = false;
  for (const char c : word) {
    if (is_digit(c))
      digit = true;
    else if (!is_sign_of_number(c))
      return false;
  }
  return digit;
}

bool read_integer(std::string_view text, std::int64_t& value) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  return read.ec == std::errc() && read.ptr == text.data() + text.size();
}

TextLines::TextLines(std::string_view bytes, std::string_view file, TextStyle style, std::uint64_t first_line)
    : bytes_(bytes), file_(file), style_(style), line_(first_line), next_line_(first_line) {
  if (bytes_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // the byte order mark that some editors put in front
}

std::string_view TextLines::physical_line() {
  const std::size_t start = at_;
  while (at_ < bytes_.size() && bytes_[at_] != '\n' && bytes_[at_] != '\r') ++at_;
  std::string_view text = bytes_.substr(start, at_ - start);
  if (at_ < bytes_.size()) at_ += bytes_[at_] == '\r' && at_ + 1 < bytes_.size() && bytes_[at_ + 1] == '\n' ? 2 : 1;
  ++next_line_;
  if (style_.comments) text = text.substr(0, text.find('#'));
  return text;
}

bool TextLines::next_line() {
  while (at_ < bytes_.size()) {
    line_ = next_line_;
    text_ = physical_line();
    is_joined_ = style_.continuations && text_.ends_with('\\');
    if (is_joined_) {
      joined_.clear();
      while (text_.ends_with('\\')) {
        joined_ += text_.substr(0, text_.size() - 1);
        joined_ += ' ';
        text_ = at_ < bytes_.size() ? physical_line() : std::string_view();
      }
      joined_ += text_;
      text_ = joined_;
    }
    while (!text_.empty() && is_space(text_.front())) text_.remove_prefix(1);
    if (!text_.empty()) return true;
  }
  text_ = {};
  return false;
}

std::string_view TextLines::token_on_line() {
  std::size_t start = 0;
  while (start < text_.size() && is_space(text_[start])) ++start;
  std::size_t end = start;
  while (end < text_.size() && !is_space(text_[end])) ++end;
  const std::string_view token = text_.substr(start, end - start);
  text_.remove_prefix(end);
  return token;
}

std::string_view TextLines::next_token() {
  const std::string_view token = token_on_line();
  return token.empty() && style_.flowing && next_line() ? token_on_line() : token;
}

bool TextLines::at_line_end() {
  while (!text_.empty() && is_space(text_.front())) text_.remove_prefix(1);
  return text_.empty();
}

std::string_view TextLines::rest() {
  std::string_view rest = text_;
  text_ = {};
  while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
  while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
  return rest;
}

TextLines::Words TextLines::words_left() {
  const std::string_view left = rest();
  Words words{left, 0, true};
  bool within = false, digit = true;  // of the word that was begun
  for (const char c : left) {
    if (is_space(c)) {
      within = false;
      continue;
    }
    if (!within) {
      words.numbers = words.numbers && digit;
      ++words.count;
      within = true;
      digit = false;
    }
    if (is_digit(c))
      digit = true;
    else if (!is_sign_of_number(c))
      words.numbers = false;
  }
  words.numbers = words.numbers && digit;
  return words;
}

void TextLines::note_odd_line(const std::string& text) {
  if (!odd_) odd_ = {line_, text};
}

void TextLines::fail(MeshFileProblem problem, const std::string& text) const {
  if (!odd_) fail_at_line(problem, file_, line_, text);
  const std::string further =
      odd_->line == line_
          ? "; mend the line or export the file again"
          : "; read on over the ends of lines, what is wrong is found in line " + std::to_string(line_) + ": " + text;
  fail_at_line(MeshFileProblem::syntax, file_, odd_->line, odd_->text + further);
}

void TextLines::fail_at_end(std::string_view expected) const {
  fail(MeshFileProblem::truncated,
       "the file ends here, expected " + std::string(expected) + "; it is cut short: fetch or export it again");
}

void TextLines::require_line(std::string_view expected) {
  if (!next_line()) fail_at_end(expected);
}

std::string_view TextLines::require_token(std::string_view expected) {
  const std::string_view token = token_on_line();
  if (!token.empty()) return token;
  const auto short_line = [&] { return "the line ends where " + std::string(expected) + " was expected"; };
  if (!style_.flowing) fail(MeshFileProblem::syntax, short_line() + "; complete the line or export the file again");
  if (!odd_) note_odd_line(short_line());
  if (!next_line()) fail_at_end(expected);
  return token_on_line();
}

double TextLines::coordinate(DecimalReader& decimals, std::string_view name) {
  const std::string_view token = require_token(name);
  double value = 0;
  const auto found = [&] { return std::string(name) + " is " + in_quotes(token); };
  switch (decimals.read(token, value)) {
    case DecimalReader::Outcome::number:
      return value;
    case DecimalReader::Outcome::not_finite:
      odd_.reset();  // whatever the lines are, this is wrong
      fail(MeshFileProblem::bad_number, found() + ", expected a finite number; mend the tool that computed it");
    case DecimalReader::Outcome::too_large:
      odd_.reset();
      fail(MeshFileProblem::bad_number,
           found() + ", beyond the largest double, expected at most 1.7976931348623157e308; scale the mesh down");
    case DecimalReader::Outcome::not_decimal:
      break;
  }
  fail(MeshFileProblem::bad_number,
       found() + ", expected a decimal number such as -1.5e-3; the decimal sign is a point");
}

Point3 TextLines::point(DecimalReader& decimals) {
  const double x = coordinate(decimals, "coordinate x");
  const double y = coordinate(decimals, "coordinate y");
  const double z = coordinate(decimals, "coordinate z");
  return {x, y, z};
}

std::uint64_t TextLines::count(std::string_view name) {
  const std::string_view token = require_token(name);
  std::int64_t value = -1;
  if (!read_integer(token, value) || value < 0)
    fail(MeshFileProblem::syntax,
         std::string(name) + " is " + in_quotes(token) + ", expected a whole number from 0; mend the line");
  return static_cast<std::uint64_t>(value);
}

std::uint32_t TextLines::index(std::string_view token, std::uint64_t vertices) const {
  std::int64_t value = -1;
  if (!read_integer(token, value) || value < 0 || static_cast<std::uint64_t>(value) >= vertices)
    fail(MeshFileProblem::bad_index, "the face names vertex " + in_quotes(token) +
                                         ", expected a whole number from 0 and below " + std::to_string(vertices) +
                                         ", the number of vertices; renumber the face");
  return static_cast<std::uint32_t>(value);
}

}  // namespace plumb::surface
