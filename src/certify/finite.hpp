// Are all arguments of a composed decision real numbers?  Looked at first, where a decision may be taken before some
// argument is used.
//
// Cost: one comparison for each coordinate.
#pragma once

#include <array>
#include <limits>
#include <tuple>

#include "plumb/certify/sign_of.hpp"

namespace plumb {

/// Throws NonFinite, naming the argument by its letter, as a formula of that name would.
template <class... Arguments>
void require_finite(std::string_view name, const Arguments&... arguments) {
  const auto all = std::apply([](auto... x) { return std::array<double, sizeof...(x)>{x...}; },
                              std::tuple_cat(coordinates(arguments)...));
  constexpr std::array counts{coordinate_count<Arguments>...};
  bool finite = true;
  for (const double x : all) finite &= magnitude_of(x) <= std::numeric_limits<double>::max();
  if (!finite) throw_non_finite(name, counts, all);
}

}  // namespace plumb
