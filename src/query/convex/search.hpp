// GJK, separating plane: do two convex hulls of many points overlap, or are they apart?  A guess in doubles, and its
// proof.
//
// Laws: an answer is that of real arithmetic: a plane with all of one on one side and all of the other beyond, or four
// pairs of points whose differences have the origin strictly inside of their tetrahedron.  Where neither is found, as
// where the hulls touch or lie in one plane, there is none.
// Method: the simplex of differences nearest to the origin, grown by support points, which on a polyhedron are climbed
// to from the last one.  A vertex that none of its neighbors is beyond is the farthest, so that few signs prove a
// plane.
// Source: Gilbert, Johnson and Keerthi 1988; RTCD 9.5, 9.5.4, 5.2.1.
// Cost: below a microsecond, times the way climbed.
#pragma once

#include <optional>

#include "query/convex/flat_view.hpp"

namespace plumb::query {

/// One is a ConvexPolyhedron3, the other one as well or a figure of few points.
std::optional<Relation> relate_by_search(const FlatView& a, const FlatView& b);

}  // namespace plumb::query
