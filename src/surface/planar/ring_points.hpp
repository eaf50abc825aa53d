// Which points do the rings of a polygon have, one ring behind the other?
#pragma once

#include <cstdint>
#include <vector>

namespace plumb::surface {

template <class Point>
struct RingPoints {
  std::vector<Point> points;
  std::vector<std::uint32_t> first{0};  // of each ring, and the number of points
};

template <class Point, class HoledPolygon>
RingPoints<Point> ring_points(const HoledPolygon& polygon) {
  RingPoints<Point> rings;
  const auto add = [&](const auto& ring) {
    rings.points.insert(rings.points.end(), ring.vertices.begin(), ring.vertices.end());
    rings.first.push_back(static_cast<std::uint32_t>(rings.points.size()));
  };
  add(polygon.outer);
  for (const auto& hole : polygon.holes) add(hole);
  return rings;
}

}  // namespace plumb::surface
