#include "plumb/degenerate/domain.hpp"

#include <algorithm>
#include <cmath>

#include "degenerate/fields.hpp"
#include "plumb/arith/error.hpp"
#include "plumb/certify/case_line.hpp"
#include "plumb/degenerate/ulps.hpp"

namespace plumb::degenerate {

namespace {

bool holds(const Domain& d, double x) {
  const double size = std::fabs(x);
  return x == 0 || (size >= d.smallest && size <= d.largest && mantissa_length(x) <= d.bits &&
                    (d.grid == 0 || lowest_exponent(x) >= lowest_exponent(d.grid)));
}

bool is_special(const Kind& kind, std::span<const double> numbers) {
  return is_degenerate(kind, numbers) || (kind.special && kind.special(numbers));
}

// The power of two that brings all into bounds, as far as the largest of them allows.
int scale_of(const Domain& d, std::span<const double> lengths) {
  double largest = 0, smallest = std::numeric_limits<double>::infinity();
  int lowest = 1024;
  for (const double x : lengths) {
    if (x == 0) continue;
    largest = std::max(largest, std::fabs(x));
    smallest = std::min(smallest, std::fabs(x));
    lowest = std::min(lowest, lowest_exponent(x));
  }
  if (largest == 0) return 0;
  const auto up_to = [](double from, double to) {  // the last power that leaves `from` at `to` or below
    const int power = highest_exponent(to) - highest_exponent(from);
    return std::ldexp(from, power) <= to ? power : power - 1;
  };
  int wanted = 0;
  if (d.grid > 0) wanted = std::max(wanted, lowest_exponent(d.grid) - lowest);
  if (smallest < d.smallest) wanted = std::max(wanted, -up_to(d.smallest, smallest));
  return std::min(wanted, up_to(largest, d.largest));
}

// To the nearest multiple of 2^exponent that is not beyond the largest.
double rounded_to(double x, int exponent, double largest) {
  const double units = std::ldexp(x, -exponent), nearest = std::ldexp(std::nearbyint(units), exponent);
  return std::fabs(nearest) <= largest ? nearest : std::ldexp(std::trunc(units), exponent);
}

double fitted(const Domain& d, double x) {
  if (d.grid > 0 && lowest_exponent(x) < lowest_exponent(d.grid)) {
    x = rounded_to(x, lowest_exponent(d.grid), d.largest);
  }
  if (mantissa_length(x) > d.bits) x = rounded_to(x, highest_exponent(x) - d.bits + 1, d.largest);
  return std::fabs(x) < d.smallest ? 0 : x;
}

}  // namespace

void require_sense(const Domain& d) {
  const auto require = [](bool sense, std::string_view what) {
    if (!sense) throw Error(std::string("domain: ").append(what));
  };
  const double least = std::max({d.smallest, d.grid, std::numeric_limits<double>::denorm_min()});
  require(std::isfinite(d.largest) && d.largest > 0, "the largest magnitude must be a number above 0");
  require(d.smallest >= 0 && d.grid >= 0, "the smallest magnitude and the grid must be 0 or more");
  require(least <= d.largest,
          "no number but 0 is in it: the smallest magnitude and the grid must not be beyond the largest");
  require(d.grid == 0 || (std::isfinite(d.grid) && mantissa_length(d.grid) == 1),
          "the grid must be a power of two, such as 0.125 or 1");
  require(d.bits >= 1 && d.bits <= std::numeric_limits<double>::digits, "a mantissa has 1 to 53 bits");
}

bool is_in(const Domain& domain, const Kind& kind, std::span<const double> numbers) {
  if (domain == Domain{}) return true;
  for (const Field& f : lengths_of(kind, numbers)) {
    const auto inside = [&](double x) { return holds(domain, x); };
    if (!std::ranges::all_of(numbers.subspan(f.first, f.size()), inside)) return false;
  }
  return domain.degenerate || !is_special(kind, numbers);
}

std::optional<Numbers> fitted(const Domain& domain, const Kind& kind, Numbers numbers) {
  if (domain == Domain{}) return numbers;
  const std::vector<Field> fields = lengths_of(kind, numbers);
  Numbers lengths = gathered(numbers, fields);
  const int scale = scale_of(domain, lengths);
  for (double& x : lengths) x = fitted(domain, scale == 0 ? x : std::ldexp(x, scale));
  scatter(lengths, fields, numbers);
  put_in_order(kind, numbers);
  if (!flaw_of(kind, numbers).empty() || !is_in(domain, kind, numbers)) return std::nullopt;
  return numbers;
}

}  // namespace plumb::degenerate
