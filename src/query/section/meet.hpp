// Clipping: what do two convex sets have in common?  The hull of what the edges of each have in common with the other.
//
// Laws: every vertex of the common set is an end of the piece of an edge within the other set (or a vertex as given),
// so that edges alone need be clipped, and every corner is a vertex or an edge across a bound: a point that points as
// given construct.  All but sets of a plane and a solid are done: of two solids the common set is none of these.
// Numbers with running bounds first, pairs of doubles where they cannot tell, integers in the end.
// Source: RTCD 5.3.3, 5.3.8, 5.2.10; docs/intersection.md.
// Cost: edges times bounds.
#pragma once

#include "plumb/query/section/intersection_result.hpp"
#include "query/convex/set.hpp"

namespace plumb::query::meeting {

Intersection2 meet(const ConvexSet<2>& a, const ConvexSet<2>& b);
Intersection3 meet(const ConvexSet<3>& a, const ConvexSet<3>& b);

}  // namespace plumb::query::meeting
