// What is refused of points and segments before they are triangulated, and how a crossing is told?
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "plumb/certify/exact_point.hpp"

namespace plumb::surface {

/// Throws NonFinite: "delaunay: points[3].x is nan, not a real number", or Error where there are too many.
void require_points(const char* question, std::span<const Point2> points);

/// Throws Error: "delaunay: segments[2] ends at point 7, and there are 7".
void require_segments(const char* question, std::span<const Point2> points,
                      std::span<const std::array<std::uint32_t, 2>> segments);

std::string crossing_text(std::uint32_t one, std::uint32_t other, const ExactPoint2& place);

/// Throws CrossingSegments.
[[noreturn]] void throw_crossing(std::span<const Point2> points, std::span<const std::array<std::uint32_t, 2>> segments,
                                 const std::array<std::uint32_t, 2>& crossing);

}  // namespace plumb::surface
