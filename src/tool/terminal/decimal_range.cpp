#include "tool/terminal/decimal_range.hpp"

#include <fmt/format.h>
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "plumb/arith/error.hpp"
#include "tool/terminal/terminal.hpp"

namespace plumb::tool {
namespace {

/// mantissa * 10^exponent
struct Scaled {
  mpz_class mantissa;
  int exponent = 0;
};

constexpr int largest_exponent = 400;  // beyond that no decimal is near a double other than zero

Scaled scaled(std::string_view text, std::string_view what) {
  const std::size_t e = text.find_first_of("eE");
  std::string digits(text.substr(0, e));
  Scaled number;
  if (e != std::string_view::npos) {
    const char* const from = text.data() + e + 1 + (text.substr(e + 1, 1) == "+" ? 1 : 0);
    const auto [end, error] = std::from_chars(from, text.data() + text.size(), number.exponent);
    if (error != std::errc() || end != text.data() + text.size() || std::abs(number.exponent) > largest_exponent)
      throw Error(fmt::format("{}: the exponent of '{}' is beyond doubles", what, text));
  }
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    number.exponent -= static_cast<int>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  if (digits.starts_with('+')) digits.erase(0, 1);
  number.mantissa = mpz_class(digits, 10);
  return number;
}

mpz_class power_of_ten(int exponent) {
  mpz_class x;
  mpz_ui_pow_ui(x.get_mpz_t(), 10, static_cast<unsigned long>(exponent));
  return x;
}

/// Without an exponent, and without zeros at the end of its fraction.
std::string plain(const mpz_class& mantissa, int exponent) {
  mpz_class magnitude = abs(mantissa);
  if (exponent > 0) magnitude *= power_of_ten(exponent);
  std::string digits = magnitude.get_str();
  if (exponent < 0) {
    const auto places = static_cast<std::size_t>(-exponent);
    if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
    digits.insert(digits.size() - places, 1, '.');
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.ends_with('.')) digits.pop_back();
  }
  return sgn(mantissa) < 0 ? "-" + digits : digits;
}

}  // namespace

void refuse_decimal(DecimalReader::Outcome outcome, std::string_view text, std::string_view what) {
  constexpr std::size_t most = 60;  // a file that holds no numbers may have long words
  const std::string shown = printable(text.substr(0, most)) + (text.size() > most ? "..." : "");
  if (outcome == DecimalReader::Outcome::too_large)
    throw Error(fmt::format("{}: {} is beyond the largest double", printable(what), shown));
  throw Error(fmt::format("{}: '{}' is not a decimal number; write one such as 1.5", printable(what), shown));
}

Decimal read_decimal(std::string_view text, std::string_view what) {
  DecimalReader reader;
  const double value = read_decimal(reader, text, [what] { return what; });
  return {std::string(text), value, reader.inexact() == 0};
}

std::vector<Decimal> decimal_range(std::string_view start, std::string_view stop, std::string_view step,
                                   std::string_view what, std::size_t most) {
  std::array<Scaled, 3> given;
  std::size_t i = 0;
  for (const std::string_view text : {start, stop, step}) {
    read_decimal(text, what);
    given[i++] = scaled(text, what);
  }
  const int exponent = std::min({given[0].exponent, given[1].exponent, given[2].exponent});
  for (Scaled& s : given) s.mantissa *= power_of_ten(s.exponent - exponent);
  const auto& [from, to, by] = given;
  if (by.mantissa <= 0) throw Error(fmt::format("{}: the step {} is not positive", what, step));
  if (to.mantissa < from.mantissa) throw Error(fmt::format("{}: the range ends at {}, below {}", what, stop, start));
  const mpz_class many = (to.mantissa - from.mantissa) / by.mantissa + 1;
  if (many > mpz_class(static_cast<unsigned long>(most)))
    throw Error(fmt::format("{}: {} planes are more than {}; take a longer step", what, many.get_str(), most));
  std::vector<Decimal> numbers;
  for (mpz_class x = from.mantissa; x <= to.mantissa; x += by.mantissa)
    numbers.push_back(read_decimal(plain(x, exponent), what));
  return numbers;
}

}  // namespace plumb::tool
