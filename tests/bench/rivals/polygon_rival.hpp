// Points in polygons by CGAL.
#pragma once

#include <functional>
#include <span>

#include "plumb/figure/basic/polygon.hpp"

namespace plumb::bench {

/// Locates all points; the sum of the answers (1 inside, 0 on the boundary, -1 outside).  Converted beforehand.
std::function<long()> cgal_bounded_side(const Polygon2& polygon, std::span<const Point2> points);

}  // namespace plumb::bench
