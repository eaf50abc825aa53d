// The hulls of CGAL over Epick: the number of vertices.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"

namespace plumb::bench {

/// CGAL's own points, made before the clock runs.
class CgalPoints {
 public:
  explicit CgalPoints(std::span<const Point3> points);
  ~CgalPoints();
  std::size_t hull_vertices() const;

 private:
  struct Held;
  Held* held_;
};

}  // namespace plumb::bench
