// How do a point and a shape, or two shapes, lie to one another?  Touching is told from overlapping.
//
// Laws: shapes are closed sets.  A point is inside where a ball around it (in the space of the shape's dimension: the
// plane for 2D types, space for 3D types) lies in the shape, so a shape without interior, a segment or flat box in
// space, is all boundary.  Two shapes overlap where their interiors do, taking a shape without interior for its
// interior relative to its own affine hull; they touch where they only have boundary points in common.
// Source: RTCD 4.2.1, 5.2.
// Cost: none.
#pragma once

#include "plumb/predicates/standard.hpp"

namespace plumb {

enum class Location : signed char { outside = -1, boundary = 0, inside = 1 };

enum class Relation : signed char { disjoint = -1, touching = 0, overlapping = 1 };

}  // namespace plumb
