// Which dimension do points have, and which of them span it?
//
// Doubles choose points that lie far apart; that they do span what they are to span is an exact sign, and where it is
// zero all points are asked.
#pragma once

#include "figure/hull/hull3_surface.hpp"

namespace plumb::figure::hull3 {

/// The first dimension + 1 of `simplex` are affinely independent; simplex[0] and [1] are the lexicographically first
/// and last node.
struct Start {
  int dimension = -1;
  std::array<Id, 4> simplex{none, none, none, none};
};

Start find_start(std::span<const Node> nodes);

}  // namespace plumb::figure::hull3
