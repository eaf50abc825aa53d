// Are these vertices of a polygon or mesh at all?  Enough of them, and real numbers.
//
// Cost: one comparison for each coordinate.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "plumb/arith/error.hpp"
#include "plumb/certify/sign_of.hpp"

namespace plumb {

/// Throws NonFinite for the first point that has a NaN or infinity: "locate: polygon.vertices[3].x is nan, ...".
template <class Point>
void require_finite_points(std::string_view function, std::string_view part, std::span<const Point> points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto x = coordinates(points[i]);
    double rest = 0;
    for (const double c : x) rest += c - c;
    if (rest == 0) continue;
    const std::string name = std::string(part).append("[").append(std::to_string(i)).append("]");
    const std::array<std::string_view, 1> names{name};
    throw_non_finite(function, std::array{static_cast<int>(x.size())}, x, "xyz", names);
  }
}

/// The same, and throws InvalidShape for fewer than three points.
template <class Point>
void require_chain(std::string_view function, std::string_view part, std::span<const Point> points) {
  if (points.size() < 3) {
    throw InvalidShape(std::string(function)
                           .append(": ")
                           .append(part)
                           .append(" has ")
                           .append(std::to_string(points.size()))
                           .append(points.size() == 1 ? " vertex" : " vertices")
                           .append("; a polygon has three at least"));
  }
  require_finite_points(function, part, points);
}

}  // namespace plumb
