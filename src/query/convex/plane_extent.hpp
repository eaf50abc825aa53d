// Plane test, support along the normal: on which sides of a plane does a figure lie?  From the least to the greatest
// value of normal . x - offset.
//
// Laws: exact.  Nothing is answered where the normal is zero, or of figures that have neither few points nor vertices.
// Source: RTCD 5.2.2, 5.2.3.
// Cost: some ns a point where doubles tell; a microsecond where one does not.
#pragma once

#include <optional>

#include "query/convex/flat_view.hpp"

namespace plumb::query {

/// `plane` is a Plane3, a Halfspace3 or a Halfspace2.
std::optional<Relation> relate_by_extent(const FlatView& plane, const FlatView& other);

}  // namespace plumb::query
