// Which cells does a ray or a segment go through, where it runs along what is between them?  One answer for grids, octrees
// and k-d trees.
//
// Source: RTCD 7.4.1, 7.4.2.
// Cost: none.  Nothing is searched.
#pragma once

#include "plumb/predicates/standard.hpp"

namespace plumb {

/// closed: each cell whose closed set it touches, by a corner, an edge or a wall as well.
/// half_open: each cell that holds a point of it, where a point between cells is in one of them: each is in one cell.
enum class WalkedCells : unsigned char { closed, half_open };

}  // namespace plumb
