// How is one case written down?  One line of text, the same in failure messages, corpora, regression files, the
// program's input and bug reports:
//
//   insphere 0x1.8p-3 -0x0p+0 ... = +      # a remark
//
// predicate, its coordinates point after point (hexadecimal doubles; decimals are read to the nearest double), then
// optionally '=' and the expected sign '+', '0' or '-'.  Blank lines and lines that start with '#' are no cases.
// Law: parse_case_line(to_string(c)) == c, bit for bit.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/arith/sign.hpp"

namespace plumb {

struct CaseLine {
  std::string predicate;
  std::vector<double> coordinates;
  Unsure<Sign> expected;  // unsure when the line states none
  friend bool operator==(const CaseLine&, const CaseLine&) = default;
};

/// Nothing for a blank line or a comment.  Throws Error, which says what was expected and where, for anything else that
/// is no case: an unknown predicate, a wrong number of coordinates, a word that is no number, a NaN or infinity
/// (NonFinite).
std::optional<CaseLine> parse_case_line(std::string_view line);

std::string to_string(const CaseLine& c);

/// The next word of the line, which is cut off it; a '#' ends the line.
std::string_view next_word(std::string_view& line);

/// A word as an error quotes it: control characters are spelled out, for a NUL would end the text of an exception, and
/// others would steer a terminal.
std::string quoted_word(std::string_view word);

/// A double as a hexadecimal literal that any C or C++ compiler, Python's float.fromhex and parse_case_line read back.
std::string hexadecimal(double x);
void append_hexadecimal(std::string& to, double x);

/// The nearest double to a decimal or hexadecimal literal, with optional sign; throws Error naming the word.
double parse_double(std::string_view word);

}  // namespace plumb
