// Is a small figure beyond one of these halfspaces, or is a point of its inside within all of them?  Guesses, proved.
//
// Laws: an answer is that of real arithmetic: the figure lies beyond a combination of halfspaces with weights that are
// not negative, or a combination of its points with weights that are all positive is strictly within all.  Where
// neither is found there is none. Method: the figure is cut by one halfspace after another in doubles, each corner kept
// as weights of the points that the figure is given by; what is left has a middle.  If nothing is left, a game between
// halfspaces and points finds the other weights.  Source: RTCD 5.3.8, 8.3.4 (cutting); Brown 1951.  Cost: about a
// microsecond, some ten for the game.
#pragma once

#include <optional>

#include "flat_view.hpp"

namespace plumb::query {

/// `halfspaces` is a k-DOP or an intersection of halfspaces.
std::optional<Relation> relate_by_clipping(const FlatView& halfspaces, const FlatView& other);

}  // namespace plumb::query
