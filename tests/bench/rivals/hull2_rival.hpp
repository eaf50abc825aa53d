// The hulls of CGAL over Epick in the plane: the number of vertices.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "plumb/arith/point.hpp"

namespace plumb::bench {

/// CGAL's own points, made before the clock runs.
class CgalPoints2 {
 public:
  explicit CgalPoints2(std::span<const Point2> points);
  [[nodiscard]] std::size_t hull_vertices() const;

 private:
  struct Held;
  std::shared_ptr<const Held> held_;
};

}  // namespace plumb::bench
