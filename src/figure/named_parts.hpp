// Which part of a shape is no real number?  Looked at first, by functions that answer with more than one sign.
//
// Cost: one comparison for each coordinate.
#pragma once

#include <algorithm>

#include "plumb/certify/sign_of.hpp"

namespace plumb {

/// Throws NonFinite naming the function and the part: "barycentric: triangle.b.y is nan, ...".
template <std::size_t N, class... Parts>
void require_finite_parts(std::string_view function, const std::array<std::string_view, N>& names,
                          const Parts&... parts) {
  static_assert(N == sizeof...(Parts));
  const auto all = std::apply([](auto... x) { return std::array<double, sizeof...(x)>{x...}; },
                              std::tuple_cat(coordinates(parts)...));
  if (std::ranges::all_of(all, [](double x) { return x - x == 0; })) return;
  constexpr std::array counts{coordinate_count<Parts>...};
  throw_non_finite(function, counts, all, "xyz", names);
}

}  // namespace plumb
