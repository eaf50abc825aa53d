#include "plumb/degenerate/domain.hpp"

#include <algorithm>
#include <cmath>

#include "certify/case_line.hpp"
#include "degenerate/fields.hpp"
#include "degenerate/words.hpp"
#include "plumb/arith/error.hpp"
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

/// The largest number in it but for its least magnitude: a multiple of the grid and of the last of its bits.
double largest_in(const Domain& d) {
  const int last_bit = highest_exponent(d.largest) - d.bits + 1;
  const int exponent = d.grid > 0 ? std::max(last_bit, lowest_exponent(d.grid)) : last_bit;
  return std::ldexp(std::trunc(std::ldexp(d.largest, -exponent)), exponent);
}

}  // namespace

std::optional<DomainFlaw> flaw_of(const Domain& d) {
  if (!(d.largest > 0) || !std::isfinite(d.largest)) return DomainFlaw{"largest", "a number above 0 is wanted"};
  if (!(d.smallest >= 0) || !std::isfinite(d.smallest))
    return DomainFlaw{"smallest", "0 or a number above it is wanted"};
  if (d.grid != 0 && !(d.grid > 0 && std::isfinite(d.grid) && mantissa_length(d.grid) == 1))
    return DomainFlaw{"grid", "a power of two is wanted, such as 0.125 or 1"};
  if (d.bits < 1 || d.bits > std::numeric_limits<double>::digits)
    return DomainFlaw{"bits", "a mantissa has 1 to 53 bits"};
  const double most = largest_in(d);
  if (most == 0) return DomainFlaw{"grid", "it is beyond the largest magnitude, so that there is no number but 0"};
  if (most < d.smallest) {
    return DomainFlaw{"smallest", std::string("there is no number but 0: ")
                                      .append(decimal(most))
                                      .append(" is the largest that the magnitude, the grid and the bits allow")};
  }
  return std::nullopt;
}

void require_sense(const Domain& domain) {
  if (const auto flaw = flaw_of(domain))
    throw Error(std::string("domain: ").append(flaw->member).append(": ").append(flaw->why));
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
