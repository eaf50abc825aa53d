// Where are a mesh's triangles: the boxes of those in its slots, and the largest number.
#pragma once

#include <algorithm>

#include "plumb/space/bvh/bvh.hpp"
#include "space/bvh/checked_box.hpp"
#include "space/bvh/parts.hpp"

namespace plumb::space {

inline Aabb3 box_around(const Point3& a, const Point3& b, const Point3& c) {
  return {{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
          {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}};
}

inline Aabb3 box_around(const Bvh::Corners& c, std::span<const Point3> vertices) {
  return box_around(vertices[c[0]], vertices[c[1]], vertices[c[2]]);
}

/// The largest of magnitude_of(i), each without NaN.
template <class MagnitudeOf>
double largest(Execution execution, std::size_t n, const MagnitudeOf& magnitude_of) {
  constexpr std::size_t block_size = 1 << 14;
  std::vector<double> most(blocks_of(n, block_size));
  for_blocks(execution, n, block_size, [&](std::size_t b, std::size_t from, std::size_t to) {
    double m = 0;
    for (std::size_t i = from; i < to; ++i) m = std::max(m, magnitude_of(i));
    most[b] = m;
  });
  return most.empty() ? 0 : *std::max_element(most.begin(), most.end());
}

/// The frame that a tree of these has.
inline BoxFrame frame_of(Execution execution, std::span<const Point3> vertices) {
  return BoxFrame::for_magnitude(
      largest(execution, vertices.size(), [&](std::size_t i) { return magnitude(vertices[i]); }));
}
inline BoxFrame frame_of(Execution execution, std::span<const Aabb3> boxes) {
  return BoxFrame::for_magnitude(largest(execution, boxes.size(), [&](std::size_t i) {
    return std::max(magnitude(boxes[i].min), magnitude(boxes[i].max));
  }));
}

/// Closed boxes of finite numbers.
inline bool boxes_meet(const Aabb3& a, const Aabb3& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
         b.min.z <= a.max.z;
}

/// Of one frame.
inline bool nodes_meet(const BoxNode& a, const BoxNode& b) {
  const auto on = [&](std::size_t k) {
    return static_cast<int>(a.min[k] <= b.max[k]) & static_cast<int>(b.min[k] <= a.max[k]);
  };
  return (on(0) & on(1) & on(2)) != 0;
}

}  // namespace plumb::space
