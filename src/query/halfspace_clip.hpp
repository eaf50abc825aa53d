// Is a small figure beyond one of these halfspaces, or is a point of its inside within all of them?  Guesses, proved.
//
// Laws: an answer is that of real arithmetic: the figure lies beyond one halfspace, or a combination of its points with
// weights that are all positive is strictly within all.  Where neither is found there is none.
// Method: the figure is cut by one halfspace after another in doubles, each corner kept as weights of the points that
// the figure is given by; what is left has a middle.  Source: RTCD 5.3.8, 8.3.4 (cutting).  Cost: about a microsecond.
#pragma once

#include <optional>

#include "flat_view.hpp"

namespace plumb::query {

/// `halfspaces` is a k-DOP or an intersection of halfspaces.
std::optional<Relation> relate_by_clipping(const FlatView& halfspaces, const FlatView& other);

}  // namespace plumb::query
