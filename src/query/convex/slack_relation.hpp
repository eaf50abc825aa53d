// Linear programming: how does a figure lie to what halfspaces bound?  By the greatest slack that a point of it has in
// all of them.
//
// A figure is the image of numbers that lie between few bounds (a triangle of two, a box of three), or of all numbers
// where it is bounded by halfspaces itself.  Its relative interior is the image of those with slack in the bounds, so
// the sign of the greatest slack tells disjoint, touching and overlapping apart where what halfspaces bound has an
// inside.
// Laws: an answer is that of real arithmetic.  Nothing is answered where what halfspaces bound has no inside and the
// figure meets it, nor of planes without a normal; boxes are not empty.
// Source: RTCD 5.2.1, 9.4; figure/k_dop/halfspace_slack.hpp for the method.
// Cost: 1 to 10 us apart from touching or overlapping by ulps, some ten more there.
#pragma once

#include <optional>

#include "query/convex/flat_view.hpp"

namespace plumb::query {

/// `solid` is a k-DOP, an intersection of halfspaces or a polyhedron; the other one is no polygon.
std::optional<Relation> relate_by_slack(const FlatView& solid, const FlatView& other);

}  // namespace plumb::query
