// Oriented boxes as others do them: overlap in plain doubles, and CGAL's smallest box.
#pragma once

#include <span>

#include "plumb/figure/basic/box.hpp"

namespace plumb::bench {

/// The fifteen axes in plain doubles, for orthonormal axes, with an epsilon for parallel edges, as commonly written.
bool boxes_meet_in_doubles(const Obb3& a, const Obb3& b);

/// CGAL's oriented_bounding_box: the volume of the box with its axes that reaches as far as the points do.
double cgal_box_volume(std::span<const Point3> points);

}  // namespace plumb::bench
