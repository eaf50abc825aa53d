#include "plumb/surface/file/decimal.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

#include "arith/running_error.hpp"
#include "plumb/arith/error_free.hpp"
#include "plumb/arith/strict.hpp"

namespace plumb {
namespace {

// A decimal taken apart: significand * 10^power, the significand without leading and trailing zeros.
struct Parts {
  bool well_formed = false;
  std::string_view number;        // for from_chars: without a plus sign, to the end
  std::string_view digits;        // first to last nonzero digit, maybe with the point among them
  std::uint64_t significand = 0;  // when it fits
  std::int64_t significant = 0;   // how many digits it has
  std::int64_t power = 0;
  [[nodiscard]] bool fits() const { return significant <= 19; }
};

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Beyond every exponent that matters, and far enough from the ends of the type to add lengths to it.
constexpr std::int64_t exponent_limit = std::int64_t{1} << 60;

bool read_exponent(const char*& at, const char* end, std::int64_t& exponent) {
  const bool negative = at != end && *at == '-';
  if (at != end && (*at == '-' || *at == '+')) ++at;
  if (at == end || !is_digit(*at)) return false;
  for (; at != end && is_digit(*at); ++at)
    if (exponent < exponent_limit / 16) exponent = 10 * exponent + (*at - '0');
  if (negative) exponent = -exponent;
  return true;
}

Parts take_apart(std::string_view text) {
  Parts parts;
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  parts.number = text;
  const char *at = text.data(), *const end = at + text.size();
  if (at != end && *at == '-') ++at;
  const char *first = nullptr, *last = nullptr;
  std::int64_t fraction = 0, pending = 0;  // digits behind the point; zeros since the last other digit
  bool point = false, any = false;
  for (; at != end; ++at) {
    if (*at == '.' && !point) {
      point = true;
      continue;
    }
    if (!is_digit(*at)) break;
    any = true;
    fraction += point;
    if (*at == '0') {
      pending += first != nullptr;
      continue;
    }
    if (!first) first = at;
    last = at;
    parts.significant += pending + 1;
    if (parts.fits()) {
      for (; pending > 0; --pending) parts.significand *= 10;
      parts.significand = parts.significand * 10 + static_cast<std::uint64_t>(*at - '0');
    }
    pending = 0;
  }
  std::int64_t exponent = 0;
  if (any && at != end && (*at == 'e' || *at == 'E')) any = read_exponent(++at, end, exponent);
  parts.well_formed = any && at == end;
  if (first) parts.digits = std::string_view(first, static_cast<std::size_t>(last - first) + 1);
  parts.power = exponent - fraction + pending;
  return parts;
}

bool names_no_number(std::string_view text) {
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) text.remove_prefix(1);
  if (text.starts_with("1.#")) return true;  // how old Windows libraries print them
  std::string lower;
  for (const char c : text.substr(0, 8)) lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return lower.starts_with("nan") || lower == "inf" || lower == "infinity";
}

// 10^0 to 10^22 are doubles, 5^0 to 5^27 fit 64 bits.
constexpr int largest_exact_ten = 22, largest_five = 27;

constexpr auto tens = [] {
  std::array<double, largest_exact_ten + 1> table{1};
  for (std::size_t k = 1; k < table.size(); ++k) table[k] = table[k - 1] * 10;
  return table;
}();

constexpr auto fives = [] {
  std::array<std::uint64_t, largest_five + 1> table{1};
  for (std::size_t k = 1; k < table.size(); ++k) table[k] = table[k - 1] * 5;
  return table;
}();

constexpr std::uint64_t mantissa_limit = std::uint64_t{1} << std::numeric_limits<double>::digits;

std::uint64_t odd_part(std::uint64_t n) {
  while (n % 2 == 0) n /= 2;
  return n;
}

// Is significand * 10^power a double?  Its magnitude is known to lie in a double's range.
bool short_is_exact(std::uint64_t significand, std::int64_t power) {
  if (power < 0) {
    if (-power > largest_five) return false;
    const std::uint64_t five = fives[static_cast<std::size_t>(-power)];
    return significand % five == 0 && odd_part(significand / five) < mantissa_limit;
  }
  return power <= largest_exact_ten && odd_part(significand) <= mantissa_limit / fives[static_cast<std::size_t>(power)];
}

// How many binary digits the double has behind the point.
int fraction_bits(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  const auto integer = static_cast<std::uint64_t>(std::ldexp(std::fabs(mantissa), 53));
  int trailing = 0;
  while (((integer >> trailing) & 1) == 0) ++trailing;
  return std::max(0, 53 - exponent - trailing);
}

// Decimal digits from 10^(top - 1) down to 10^-below.
struct Column {
  std::int64_t top, below;
  std::vector<signed char> digits;
  Column(std::int64_t t, std::int64_t b) : top(t), below(b), digits(static_cast<std::size_t>(t + b)) {}
  signed char& at_power(std::int64_t power) { return digits[static_cast<std::size_t>(top - 1 - power)]; }
};

constexpr std::int64_t highest = std::numeric_limits<double>::max_exponent10 + 2;

// The exact distance between a decimal and its double, not zero, to the nearest double; zero when there is none.
double exact_distance(const Parts& parts, double value) {
  const int bits = fraction_bits(value);  // binary digits behind the point make as many decimal ones
  std::array<char, 1500> buffer;
  const auto printed =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::fabs(value), std::chars_format::fixed, bits);
  const std::string_view exact(buffer.data(), static_cast<std::size_t>(printed.ptr - buffer.data()));

  Column column(highest, std::max<std::int64_t>(bits, -parts.power));
  std::int64_t power = parts.power + parts.significant;
  for (const char c : parts.digits)
    if (c != '.') column.at_power(--power) = static_cast<signed char>(c - '0');
  power = static_cast<std::int64_t>(std::min(exact.find('.'), exact.size()));
  for (const char c : exact)
    if (c != '.') {
      auto& digit = column.at_power(--power);
      digit = static_cast<signed char>(digit - (c - '0'));
    }

  auto& digits = column.digits;
  const auto leading = std::find_if(digits.begin(), digits.end(), [](signed char d) { return d != 0; });
  if (leading == digits.end()) return 0;
  if (*leading < 0)
    for (auto& digit : digits) digit = static_cast<signed char>(-digit);
  int borrow = 0;
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit) {
    const int left = *digit - borrow;
    borrow = left < 0;
    *digit = static_cast<signed char>(left + 10 * borrow);
  }
  std::string text;
  for (const signed char digit : digits) text += static_cast<char>('0' + digit);
  text += "e-" + std::to_string(column.below);
  double distance = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), distance);
  return read.ec == std::errc() && distance > 0 ? distance : std::numeric_limits<double>::denorm_min();
}

// No less than the distance of a decimal of up to 19 digits, behind whose point lie up to 22 of them.
double distance_bound(std::uint64_t significand, std::int64_t power, double value) {
  const double ten = tens[static_cast<std::size_t>(-power)];
  const auto high = static_cast<double>(significand);
  const auto low = static_cast<double>(static_cast<std::int64_t>(significand - static_cast<std::uint64_t>(high)));
  const Rounded product = two_product(std::fabs(value), ten);
  const Running off = (Running(high) - Running(product.value)) + (Running(low) - Running(product.error));
  return quotient(magnitude(off), Running(ten)).upper();
}

// The farthest that anything rounded to this double can have come from, at least the smallest subnormal.
double farthest_move(double value) {
  const double size = std::fabs(value);
  const double below = size - std::nextafter(size, 0.0);
  int exponent = 0;
  const bool power_of_two = std::frexp(size, &exponent) == 0.5;  // its upper neighbor is twice as far as the lower
  return std::max(power_of_two ? below : below / 2, std::numeric_limits<double>::denorm_min());
}

}  // namespace

void DecimalReader::note_move(double move) {
  ++inexact_;
  largest_move_ = std::max(largest_move_, move);
}

DecimalReader::Outcome DecimalReader::read(std::string_view text, double& value) {
  const Parts parts = take_apart(text);
  if (!parts.well_formed) return names_no_number(text) ? Outcome::not_finite : Outcome::not_decimal;
  const auto read = std::from_chars(parts.number.data(), parts.number.data() + parts.number.size(), value);
  const bool underflow = read.ec == std::errc::result_out_of_range && parts.significant + parts.power < 0;
  if (read.ec == std::errc::result_out_of_range && !underflow) return Outcome::too_large;
  if (underflow) value = parts.number[0] == '-' ? -0.0 : 0.0;
  ++decimals_;
  if (parts.significant == 0) return Outcome::number;
  if (value == 0) {
    note_move(std::numeric_limits<double>::denorm_min());
    return Outcome::number;
  }

  const double size = std::fabs(value);
  if (parts.fits() && parts.significand < mantissa_limit && std::abs(parts.power) <= largest_exact_ten) {
    // One rounding made the value, so what it left over is a double, and comes out of the fma unrounded.
    const double ten = tens[static_cast<std::size_t>(std::abs(parts.power))];
    const auto significand = static_cast<double>(parts.significand);
    const double left = parts.power < 0 ? std::fma(-size, ten, significand) : std::fma(significand, ten, -size);
    if (left != 0) note_move(std::fabs(left) / (parts.power < 0 ? ten : 1));
    return Outcome::number;
  }
  if (parts.fits() ? short_is_exact(parts.significand, parts.power)
                   : (parts.power >= 0 || fraction_bits(value) == -parts.power) && exact_distance(parts, value) == 0)
    return Outcome::number;
  const bool bounded = parts.fits() && parts.power < 0 && -parts.power <= largest_exact_ten;
  if (farthest_move(value) <= largest_move_ || parts.number == record_ ||
      (bounded && distance_bound(parts.significand, parts.power, value) <= largest_move_)) {
    ++inexact_;
    return Outcome::number;
  }
  const double distance = exact_distance(parts, value);
  if (distance > largest_move_) record_ = parts.number;
  note_move(distance);
  return Outcome::number;
}

}  // namespace plumb
