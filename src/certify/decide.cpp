// Compiles the exact stages of every formula of the manifest once.
#include "plumb/certify/decide.hpp"

#include <cmath>
#include <string>

#include "plumb/arith/error.hpp"

namespace plumb {

void throw_non_finite(std::string_view formula, int dimension, std::span<const double> coordinates) {
  const auto axes = static_cast<std::size_t>(dimension);
  std::size_t i = 0;
  while (i + 1 < coordinates.size() && std::isfinite(coordinates[i])) ++i;
  const double x = coordinates[i];
  const bool has_letters = axes <= 3 && i / axes < 26;
  const std::string place = has_letters ? std::string{static_cast<char>('a' + i / axes), '.', "xyz"[i % axes]}
                                        : "coordinate " + std::to_string(i);
  throw NonFinite(std::string(formula) + ": " + place + " is " +
                  (std::isnan(x)     ? "nan"
                   : std::signbit(x) ? "-inf"
                                     : "inf") +
                  ", not a real number; give a finite double");
}

#define PLUMB_INSTANTIATE(formula) \
  template Decision decide_exactly<predicates::formula>(const Coordinates<predicates::formula>&);
PLUMB_PREDICATES(PLUMB_INSTANTIATE)
#undef PLUMB_INSTANTIATE

}  // namespace plumb
