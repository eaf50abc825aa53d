// A figure whose type was forgotten, as what bounds it.
//
// Laws: exact; a figure of the plane is asked for by ConvexSet<2>, one of space by ConvexSet<3>.
// Cost: that of the set.
#pragma once

#include "plumb/query/body/pairs.hpp"
#include "query/convex/flat_set.hpp"
#include "query/convex/set.hpp"

namespace plumb::query::meeting {

/// Nothing of a figure that has no vertices and edges known in doubles or in dyadic numbers: k-DOPs, halfspaces.
std::optional<ConvexSet<2>> convex_set2(const FigureView& v);
std::optional<ConvexSet<3>> convex_set3(const FigureView& v);

/// In rationals: k-DOPs and intersections of halfspaces as well.  Empty with one halfspace that holds nothing.
std::vector<ExactHalfspace> halfspaces_of(const FigureView& v);
std::vector<ExactHalfspace> halfspaces_of(const ConvexSet<3>& set);

}  // namespace plumb::query::meeting
