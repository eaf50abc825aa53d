// Contacts as Bullet tells them: of boxes by its fifteen axes and clipping, of hulls by GJK and the expanding polytope
// algorithm, which tell one point a call.
#pragma once

#include <functional>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/convex_polyhedron.hpp"

namespace plumb::bench {

/// Asks once for each call; the shapes are made beforehand.  How many points there are.
using AskContact = std::function<int()>;

AskContact bullet_contact(const Obb3& a, const Obb3& b);
AskContact bullet_contact(const ConvexPolyhedron3& a, const ConvexPolyhedron3& b);

}  // namespace plumb::bench
