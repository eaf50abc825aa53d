// Penetration depth as others tell it: of hulls by their vertices and faces, and of oriented boxes.
#pragma once

#include <functional>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"

namespace plumb::bench {

/// Asks once for each call; the shapes are made beforehand.  The depth, NaN where there is no answer.
using AskDepth = std::function<double()>;

/// FCL's collide() with contacts: libccd's GJK and the expanding polytope algorithm, of boxes its fifteen axes.
AskDepth fcl_depth(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b);
AskDepth fcl_depth(const Obb3& a, const Obb3& b);

/// Bullet's btGjkEpaSolver2::Penetration in doubles, without margins.
AskDepth bullet_depth(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b);
AskDepth bullet_depth(const Obb3& a, const Obb3& b);

}  // namespace plumb::bench
