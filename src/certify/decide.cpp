#include "plumb/certify/decide.hpp"

#include <cmath>
#include <string>

#include "certify/refused_number.hpp"
#include "plumb/arith/error.hpp"

namespace plumb {

std::string place_of(std::size_t coordinate, std::span<const int> arguments, std::string_view axes,
                     std::span<const std::string_view> names) {
  std::size_t argument = 0, axis = coordinate;
  while (axis >= static_cast<std::size_t>(arguments[argument])) axis -= static_cast<std::size_t>(arguments[argument++]);
  const int count = arguments[argument];
  const bool named = argument < names.size();
  if (static_cast<std::size_t>(count) > axes.size() || (!named && argument >= 26))
    return "coordinate " + std::to_string(coordinate);
  std::string place = named ? std::string(names[argument]) : std::string(1, static_cast<char>('a' + argument));
  if (count > 1) place.append({'.', axes[axis]});
  return place;
}

void throw_not_a_number(const std::string& place, double x) {
  std::string text(place);
  text.append(" is ").append(std::isnan(x) ? "nan" : std::signbit(x) ? "-inf" : "inf");
  throw NonFinite(text.append(", not a real number; give a finite double"));
}

void throw_non_finite(std::string_view formula, std::span<const int> arguments, std::span<const double> coordinates,
                      std::string_view axes, std::span<const std::string_view> names) {
  std::size_t i = 0;
  while (i + 1 < coordinates.size() && std::isfinite(coordinates[i])) ++i;
  throw_not_a_number(std::string(formula).append(": ").append(place_of(i, arguments, axes, names)), coordinates[i]);
}

}  // namespace plumb
