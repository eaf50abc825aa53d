// Is every number that goes in real, and every one that comes out a double?  Lists of names, spans of points, bounds.
//
// Cost: a subtraction and an addition for each number.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "plumb/arith/error.hpp"
#include "plumb/certify/sign_of.hpp"

namespace plumb {

/// Throws NonFinite naming the function and the part: "barycentric: triangle.b.y is nan, ...".
template <class... Parts>
void require_finite_parts(std::string_view function, const std::array<std::string_view, sizeof...(Parts)>& names,
                          const Parts&... parts) {
  const auto all = std::apply([](auto... x) { return std::array<double, sizeof...(x)>{x...}; },
                              std::tuple_cat(coordinates(parts)...));
  double zero = 0;  // becomes NaN, and stays it
  for (const double x : all) zero += x - x;
  if (zero == 0) [[likely]]
    return;
  throw_non_finite(function, std::array{coordinate_count<Parts>...}, all, "xyz", names);
}

/// The same for the first point that is none: "convex_hull: points[17].y is nan, ...".
template <class Point>
void require_finite_points(std::string_view function, std::string_view name, std::span<const Point> points) {
  const auto zero_of = [](const Point& p) {
    double zero = 0;
    for (const double x : coordinates(p)) zero += x - x;
    return zero;
  };
  std::array<double, 4> zeros{};  // sums that need not wait for one another
  std::size_t whole = 0;
  for (; whole + zeros.size() <= points.size(); whole += zeros.size()) {
    for (std::size_t k = 0; k < zeros.size(); ++k) zeros[k] += zero_of(points[whole + k]);
  }
  for (; whole < points.size(); ++whole) zeros[0] += zero_of(points[whole]);
  if ((zeros[0] + zeros[1]) + (zeros[2] + zeros[3]) == 0) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (zero_of(points[i]) == 0) continue;
    const std::string which = std::string(name).append("[").append(std::to_string(i)).append("]");
    const std::array<std::string_view, 1> names{which};
    throw_non_finite(function, std::array{coordinate_count<Point>}, coordinates(points[i]), "xyz", names);
  }
}

namespace figure {

using plumb::require_finite_parts, plumb::require_finite_points;

/// The number, which must be a double: an infinity is one that none holds.
inline double within_doubles(double x, std::string_view function, std::string_view part) {
  if (x - x == 0) return x;
  throw BeyondDoubles(std::string(function).append(": ").append(part).append(
      " is beyond all doubles; scale the shape down by a power of two"));
}

}  // namespace figure

}  // namespace plumb
