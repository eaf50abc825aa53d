#include "certify/case_line.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "certify/catalog.hpp"
#include "plumb/arith/error.hpp"

namespace plumb {

std::string quoted_word(std::string_view word) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "'";
  for (const char c : word) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= ' ' && byte != 0x7f) {
      text += c;
    } else {
      text.append("\\x").append({digits[byte / 16], digits[byte % 16]});
    }
  }
  return text + "'";
}

std::string_view next_word(std::string_view& line) {
  constexpr std::string_view blank = " \t\r\n";
  const std::size_t begin = line.find_first_not_of(blank);
  if (begin == line.npos || line[begin] == '#') return line = {};
  const std::size_t end = std::min(line.find_first_of(blank, begin), line.size());
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

namespace {

Sign parse_sign(std::string_view word) {
  for (const Sign s : {Sign::negative, Sign::zero, Sign::positive}) {
    if (word.size() == 1 && word[0] == to_char(s)) return s;
  }
  throw Error("after '=' comes the expected sign '+', '0' or '-', not " + quoted_word(word));
}

// Is this unsigned literal, beyond the range of doubles, too small rather than too large?  Its first significant digit
// stands behind the point once the exponent has moved it.
bool below_one(std::string_view literal, bool hexadecimal) {
  const std::size_t mark = std::min(literal.find_first_of(hexadecimal ? "pP" : "eE"), literal.size());
  const std::string_view digits = literal.substr(0, mark);
  const auto point = static_cast<std::int64_t>(std::min(digits.find('.'), digits.size()));
  const std::size_t first = digits.find_first_not_of("0.");
  if (first == digits.npos) return true;
  std::int64_t exponent = 0;
  std::string_view power = literal.substr(std::min(mark + 1, literal.size()));
  if (power.starts_with('+')) power.remove_prefix(1);
  if (std::from_chars(power.data(), power.data() + power.size(), exponent).ec == std::errc::result_out_of_range) {
    return power.starts_with('-');
  }
  const auto places =
      point - static_cast<std::int64_t>(first);  // positive: digits before the point, the first included
  return exponent / (hexadecimal ? 4 : 1) + places < 0;
}

std::string known_predicates() {
  std::string names;
  for (const CatalogEntry& e : classics()) names += (names.empty() ? "" : ", ") + std::string(e.name);
  return names + " and " + std::to_string(catalog().size() - classics().size()) +
         " more, which `plumb sign --help` lists";
}

// "3 points of 2 coordinates", or "arguments of 3, 1 and 3 coordinates".
std::string shape_of(const CatalogEntry& e) {
  if (e.points != 0) return std::to_string(e.points) + " points of " + std::to_string(e.dimension) + " coordinates";
  std::string counts;
  for (std::size_t i = 0; i < e.arguments.size(); ++i) {
    counts += i == 0 ? "" : i + 1 == e.arguments.size() ? " and " : ", ";
    counts += std::to_string(e.arguments[i]);
  }
  return "arguments of " + counts + " coordinates";
}

}  // namespace

double parse_double(std::string_view word) {
  std::string_view rest = word;
  const bool minus = rest.starts_with('-');
  if (minus || rest.starts_with('+')) rest.remove_prefix(1);
  const bool hexadecimal = rest.starts_with("0x") || rest.starts_with("0X");
  if (hexadecimal) rest.remove_prefix(2);
  const char first = rest.empty() ? ' ' : rest.front();  // from_chars would take a second sign
  double x = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), x,
                                            hexadecimal ? std::chars_format::hex : std::chars_format::general);
  if (error == std::errc::result_out_of_range) {
    if (!below_one(rest, hexadecimal)) throw Error(quoted_word(word) + " is beyond the largest double");
    x = 0;  // the nearest double
  }
  if (first == '-' || error == std::errc::invalid_argument || end != rest.data() + rest.size()) {
    throw Error(quoted_word(word) + " is not a number; give a decimal or hexadecimal double, such as 0.1 or 0x1.8p-3");
  }
  if (!std::isfinite(x)) throw NonFinite(quoted_word(word) + " is not a real number; give a finite double");
  return minus ? -x : x;
}

void append_hexadecimal(std::string& to, double x) {
  std::array<char, 40> text{'-', '0', 'x'};
  char* const end = std::to_chars(text.data() + 3, text.data() + text.size(), std::fabs(x), std::chars_format::hex).ptr;
  to.append(text.data() + (std::signbit(x) ? 0 : 1), end);
}
std::string hexadecimal(double x) {
  std::string text;
  append_hexadecimal(text, x);
  return text;
}

std::optional<CaseLine> parse_case_line(std::string_view line) {
  const std::string_view name = next_word(line);
  if (name.empty()) return std::nullopt;
  const CatalogEntry* entry = find_predicate(name);
  if (entry == nullptr) throw Error("there is no predicate " + quoted_word(name) + "; there are " + known_predicates());
  CaseLine c{std::string(name), {}, {}};
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
    if (word == "=") {
      c.expected = Unsure{parse_sign(next_word(line))};
      if (const auto more = next_word(line); !more.empty())
        throw Error("nothing may follow the sign, but here comes " + quoted_word(more));
      break;
    }
    c.coordinates.push_back(parse_double(word));
  }
  if (c.coordinates.size() != entry->arity()) {
    throw Error(c.predicate + " takes " + shape_of(*entry) + ", " + std::to_string(entry->arity()) +
                " numbers in all, not " + std::to_string(c.coordinates.size()));
  }
  return c;
}

std::string to_string(const CaseLine& c) {
  std::string line = c.predicate;
  for (const double x : c.coordinates) line.append(" ").append(hexadecimal(x));
  if (c.expected.certain()) line += std::string(" = ") + to_char(c.expected.value());
  return line;
}

}  // namespace plumb
