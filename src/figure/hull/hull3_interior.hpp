// Which points are certainly inside?  Found at a few operations each, so that few are left to the hull.
#pragma once

#include "figure/hull/hull3_surface.hpp"

namespace plumb::figure::hull3 {

/// Nodes for all points, in ascending order, but some that are no vertices of the hull; with all_boundary_points, that
/// are not on its boundary.
std::vector<Node> outer_nodes(std::span<const Point3> points, const Extents& extents, bool all_boundary_points);

}  // namespace plumb::figure::hull3
