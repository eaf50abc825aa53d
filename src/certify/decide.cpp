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
  const std::string point(1, static_cast<char>('a' + i / axes)), axis(1, "xyz"[i % axes]);
  throw NonFinite(std::string(formula) + ": " + point + "." + axis + " is " +
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
