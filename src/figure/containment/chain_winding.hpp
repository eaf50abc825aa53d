// Point in polygon: how often does a chain wind around a point?
//
// Edges are counted that cross the horizontal ray from the point to the right, an edge with its lower end and without
// its upper one.  Four comparisons as given tell of each corner on which sides of the point it lies, a bit each, and
// the bits of 64 corners at once which edges are crossed, which are not, and of which few a sign has to be asked.
// Source: RTCD 5.4.1; Franklin's and Haines' crossings test.
// Cost: linear, half a nanosecond a corner and three an edge beside and above which the point lies.
#pragma once

#include <span>

#include "plumb/arith/point.hpp"

namespace plumb {

struct ChainWinding {
  bool is_finite = true, is_on = false;  // nothing else is told where a number is none
  int turns = 0;                         // counterclockwise, around what is not on it
};

/// Of a chain that is not empty.
ChainWinding winding_of(std::span<const Point2> chain, const Point2& p);
/// The same, but for turns: odd where those are odd.
ChainWinding parity_of(std::span<const Point2> chain, const Point2& p);

}  // namespace plumb
