// Which triangles does CGAL make of points and segments that do not cross?
//
// Laws: exact for all finite doubles; the triangles of the constrained Delaunay triangulation, any one of those that
// there are where points lie on one circle.
// Source: CGAL's manual, "2D Triangulations".
// Cost: some 100 us a point: rational numbers.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/arith/point.hpp"

namespace plumb::oracle {

/// Counterclockwise, by the lowest index of the points that equal a corner.
std::vector<std::array<std::uint32_t, 3>> constrained_triangles(std::span<const Point2> points,
                                                                std::span<const std::array<std::uint32_t, 2>> segments);

}  // namespace plumb::oracle
