// The hulls of Qhull, by its reentrant library: the number of vertices, 0 where it fails.
#pragma once

#include <cstddef>
#include <span>

#include "plumb/arith/point.hpp"

namespace plumb::bench {

std::size_t qhull_vertices(std::span<const Point2> points);
std::size_t qhull_vertices(std::span<const Point3> points);

}  // namespace plumb::bench
