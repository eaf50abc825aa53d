#include "tool/terminal/number_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plumb::tool {

std::string percent(std::uint64_t part, std::uint64_t whole) {
  if (part == 0 || whole == 0) return std::string(1, '0');
  const double p = 100.0 * static_cast<double>(part) / static_cast<double>(whole);
  return p < 0.01 ? fmt::format("{:.1e}%", p) : fmt::format("{:.3g}%", p);
}

std::string three_digits(double x) {
  if (x < 999.5) return fmt::format("{:.3g}", x);
  const double unit = std::pow(10.0, std::floor(std::log10(x)) - 2);
  return grouped(static_cast<std::uint64_t>(std::round(x / unit) * unit));
}

}  // namespace plumb::tool
