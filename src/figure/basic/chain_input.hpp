// Are these vertices of a polygon or mesh at all?  Enough of them, and real numbers.
//
// Cost: one comparison for each coordinate.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "figure/basic/finite_parts.hpp"
#include "plumb/arith/error.hpp"

namespace plumb {

/// Throws InvalidShape for fewer than three points, NonFinite for one that is none.
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
