#include "surface/planar/checked_points.hpp"

#include "figure/basic/finite_parts.hpp"
#include "plumb/surface/planar/delaunay.hpp"

namespace plumb::surface {

void require_points(const char* question, std::span<const Point2> points) {
  constexpr std::size_t most = std::size_t{1} << 29;  // their triangles' half-edges have 32 bits
  if (points.size() >= most)
    throw Error(std::string(question)
                    .append(": there are ")
                    .append(std::to_string(points.size()))
                    .append(" points, more than 2^29 - 1; divide them"));
  require_finite_points(question, "points", points);
}

void require_segments(const char* question, std::span<const Point2> points,
                      std::span<const std::array<std::uint32_t, 2>> segments) {
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (const std::uint32_t end : segments[i])
      if (end >= points.size())
        throw Error(std::string(question)
                        .append(": segments[")
                        .append(std::to_string(i))
                        .append("] ends at point ")
                        .append(std::to_string(end))
                        .append(", and there are ")
                        .append(std::to_string(points.size())));
}

std::string crossing_text(std::uint32_t one, std::uint32_t other, const ExactPoint2& place) {
  const auto& [x, y] = rational_point(place);
  return std::string("segments ")
      .append(std::to_string(std::min(one, other)))
      .append(" and ")
      .append(std::to_string(std::max(one, other)))
      .append(" cross at (")
      .append(x.text())
      .append(", ")
      .append(y.text())
      .append("); divide them there, or ask arrange_segments");
}

void throw_crossing(std::span<const Point2> points, std::span<const std::array<std::uint32_t, 2>> segments,
                    const std::array<std::uint32_t, 2>& crossing) {
  const auto &s = segments[crossing[0]], &t = segments[crossing[1]];
  throw CrossingSegments(crossing[0], crossing[1],
                         LineLinePoint2{points[s[0]], points[s[1]], points[t[0]], points[t[1]]});
}

}  // namespace plumb::surface
