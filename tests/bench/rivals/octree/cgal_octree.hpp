// CGAL's octree of points: built, and asked for the leaf of a point.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "plumb/arith/point.hpp"

namespace plumb::bench {

/// CGAL's own points, made before the clock runs.
class CgalOctree {
 public:
  explicit CgalOctree(std::span<const Point3> points);
  ~CgalOctree();
  /// The tree of all points, with so many in a leaf and so many levels at most.
  void build(std::size_t most_in_leaf, std::size_t most_depth);
  /// How many points there are in the leaves of all points, added up.
  [[nodiscard]] std::size_t located() const;

 private:
  struct Held;
  std::unique_ptr<Held> held_;
};

}  // namespace plumb::bench
