// Is a chain of finite points convex?  For who has looked at the points already.
//
// Laws: those of convexity(Polygon2).
// Cost: one orient2d a vertex.
#pragma once

#include <span>

#include "plumb/figure/basic/convexity.hpp"

namespace plumb {

/// Of at least one vertex.
PolygonConvexity chain_convexity(std::span<const Point2> chain);

}  // namespace plumb
