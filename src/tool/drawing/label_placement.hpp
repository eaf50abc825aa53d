// Where can the names of points stand, so that no name covers another name or any point?
//
// Each name tries eight sides of its point, close by first; where neighbors crowd it out it moves away and gets a
// leader line.
// Laws: (1) no two boxes overlap, none covers a marker, all lie within the area; (2) where that cannot be had there is
// no answer, never a bad one; (3) the same input gives the same places.
// Source: none.
// Cost: O(n^3) for n names, a chart's dozen in about a millisecond.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace plumb::tool {

struct Box {
  double left, top, right, bottom;
  [[nodiscard]] bool overlaps(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
  [[nodiscard]] bool contains(const Box& other) const {
    return left <= other.left && other.right <= right && top <= other.top && other.bottom <= bottom;
  }
};

struct LabelRequest {
  double x, y;           // the point
  double width, height;  // of its name
  Box home;              // where its name belongs; elsewhere in the area only where that is full
};

struct LabelPlace {
  Box box;
  bool leader;                        // the name stands away from its point
  double from_x, from_y, to_x, to_y;  // the leader line
};

std::optional<std::vector<LabelPlace>> place_labels(std::span<const LabelRequest> requests, const Box& area,
                                                    double marker_radius);

}  // namespace plumb::tool
