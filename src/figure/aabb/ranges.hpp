// Bounds of axis-aligned boxes, axis by axis, each rounded outward once.
//
// Law: an interval contains every sum of its ends; a bound that no double holds throws BeyondDoubles, by name.
// Cost: some 20 ns a bound.
#pragma once

#include <array>
#include <string_view>

#include "certify/rounded.hpp"
#include "figure/basic/finite_parts.hpp"
#include "plumb/figure/basic/box.hpp"

namespace plumb::figure::box {

// A bound of what is moved, swept or turned: t + sum of m_i x_i, and a sum of four.
inline constexpr auto image = [](auto t, auto m0, auto x0, auto m1, auto x1, auto m2, auto x2) {
  return t + (m0 * x0 + m1 * x1 + m2 * x2);
};
inline constexpr auto sum_of_four = [](auto a, auto b, auto c, auto d) { return (a + b) + (c + d); };

inline constexpr std::array<std::string_view, 3> min_name{"min.x", "min.y", "min.z"},
    max_name{"max.x", "max.y", "max.z"};

inline double least_sum(std::string_view function, std::size_t axis, double a, double b, double c = 0, double d = 0) {
  return within_doubles(rounded_value(Rounding::down, sum_of_four, a, b, c, d), function, min_name[axis]);
}
inline double greatest_sum(std::string_view function, std::size_t axis, double a, double b, double c = 0,
                           double d = 0) {
  return within_doubles(rounded_value(Rounding::up, sum_of_four, a, b, c, d), function, max_name[axis]);
}

struct Range {
  double min, max;
};

// Of t + sum of m_i x_i for x_i between from_i and to_i: each term takes the end that the sign of m_i names.
inline Range range_of_image(std::string_view function, std::size_t axis, double t, const std::array<double, 3>& m,
                            const std::array<double, 3>& from, const std::array<double, 3>& to) {
  std::array<double, 3> least, greatest;
  for (std::size_t i = 0; i < 3; ++i) {
    least[i] = m[i] < 0 ? to[i] : from[i];
    greatest[i] = m[i] < 0 ? from[i] : to[i];
  }
  return {within_doubles(rounded_value(Rounding::down, image, t, m[0], least[0], m[1], least[1], m[2], least[2]),
                         function, min_name[axis]),
          within_doubles(rounded_value(Rounding::up, image, t, m[0], greatest[0], m[1], greatest[1], m[2], greatest[2]),
                         function, max_name[axis])};
}

inline Aabb2 box_of(Range x, Range y) { return {{x.min, y.min}, {x.max, y.max}}; }
inline Aabb3 box_of(Range x, Range y, Range z) { return {{x.min, y.min, z.min}, {x.max, y.max, z.max}}; }

}  // namespace plumb::figure::box
