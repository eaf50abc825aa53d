// The hulls of others: Qhull by its reentrant library, CGAL over Epick.  Both give the number of vertices.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"

namespace plumb::bench {

std::size_t qhull_vertices(std::span<const Point3> points);

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
