// Clipping: what do two convex solids have in common, and which faces has it?
//
// Laws: a vertex of the common set is a vertex of one solid, or lies on an edge of one and a face of the other, so that
// edges alone are clipped, as in meet.hpp.  A face lies on a bound of one of them; on which bounds a corner lies is
// known from what it is made of, and of corners at one place by what all of them are made of.  What has no volume lies
// on one bound whole: solids that touch are parted by the plane of a face.
// Source: RTCD 5.3.8; Preparata and Shamos, Computational Geometry, 1985.
// Cost: edges times bounds.
#pragma once

#include "plumb/query/section/solid.hpp"
#include "query/convex/set.hpp"

namespace plumb::query::meeting {

SolidIntersection3 meet_solids(const ConvexSet<3>& a, const ConvexSet<3>& b);

}  // namespace plumb::query::meeting
