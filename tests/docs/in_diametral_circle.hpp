// The worked example of docs/add_a_predicate.md, as it is shown there.
#pragma once

#include <array>
#include <string_view>

namespace mine {

/// Positive when c is inside the circle that has the segment ab as its diameter; zero on it.
struct InDiametralCircle {
  static constexpr std::string_view name = "in_diametral_circle";
  static constexpr int points = 3, dimension = 2;
  template <class T>
  constexpr auto operator()(const std::array<T, 6>& p) const {
    return (p[0] - p[4]) * (p[4] - p[2]) + (p[1] - p[5]) * (p[5] - p[3]);
  }
};

}  // namespace mine
