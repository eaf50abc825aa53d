// Which of two points, and of a triangle's corners, comes first?  An order that no numbering changes.
//
// Law: by x, then y, then z; -0 equals +0.
// Cost: comparisons.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "plumb/arith/point.hpp"

namespace plumb::surface {

inline bool comes_before(const Point3& p, const Point3& q) {
  return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
}

/// Turns a cycle of vertices so that it begins with the one that comes first; of several such, with the one behind which
/// others come first.
inline void begin_with_first(std::span<const Point3> points, std::span<std::uint32_t> cycle) {
  const std::size_t n = cycle.size();
  std::size_t first = 0;
  for (std::size_t i = 1; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      const Point3 &p = points[cycle[(first + k) % n]], &q = points[cycle[(i + k) % n]];
      if (p == q) continue;
      if (comes_before(q, p)) first = i;
      break;
    }
  }
  std::rotate(cycle.begin(), cycle.begin() + static_cast<std::ptrdiff_t>(first), cycle.end());
}

}  // namespace plumb::surface
