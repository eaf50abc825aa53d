// Of what is a figure all points near to: which flat set is its core, and what is its radius?
//
// Laws: the figure is all that is within the radius of the core; one with straight edges is its own core, of radius zero.
// Polygons have none: they need not be convex.
// Source: RTCD 4.5.
// Cost: that of flat_set.
#pragma once

#include "query/convex/flat_set.hpp"

namespace plumb::query {

double radius_of(const FigureView& figure);
FlatSet core_of(const FigureView& figure);
template <Figure Shape>
FlatSet core_of(const Shape& s) {
  return core_of(view_of(s));
}

}  // namespace plumb::query
