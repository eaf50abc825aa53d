// Which points have a body in their hull, and which simple set is around them?
//
// Law: the hull of the points holds the part, exactly; the set holds the points.  Of a polytope or a mesh that stands where
// it was given the points are its corners, of any other part those of boxes that are rounded outward.
// Source: RTCD 2.2.2.
// Cost: linear in the corners, and that of the fit.
#pragma once

#include <optional>
#include <vector>

#include "plumb/world/any_body.hpp"

namespace plumb::world {

std::vector<Point3> points_around(const AnyBody::Part& part);
/// Nothing where doubles hold no such set.
std::optional<AnyFigure> proxy_around(const std::vector<Point3>& points, ProxyKind kind);

}  // namespace plumb::world
