#include "plumb/certify/decide.hpp"

#include <cmath>
#include <string>

#include "plumb/arith/error.hpp"

namespace plumb {

namespace {

// "b.y", "b" or "coordinate 4".
std::string place_of(std::size_t coordinate, std::span<const int> arguments, std::string_view axes) {
  std::size_t argument = 0, axis = coordinate;
  while (axis >= static_cast<std::size_t>(arguments[argument])) axis -= static_cast<std::size_t>(arguments[argument++]);
  const int count = arguments[argument];
  if (static_cast<std::size_t>(count) > axes.size() || argument >= 26)
    return "coordinate " + std::to_string(coordinate);
  std::string place(1, static_cast<char>('a' + argument));
  if (count > 1) place.append({'.', axes[axis]});
  return place;
}

}  // namespace

void throw_non_finite(std::string_view formula, std::span<const int> arguments, std::span<const double> coordinates,
                      std::string_view axes) {
  std::size_t i = 0;
  while (i + 1 < coordinates.size() && std::isfinite(coordinates[i])) ++i;
  const double x = coordinates[i];
  throw NonFinite(std::string(formula) + ": " + place_of(i, arguments, axes) + " is " +
                  (std::isnan(x)     ? "nan"
                   : std::signbit(x) ? "-inf"
                                     : "inf") +
                  ", not a real number; give a finite double");
}

}  // namespace plumb
