// Generate and prune: which few of many candidate balls hold all pieces?
#pragma once

#include <span>
#include <vector>

#include "plumb/figure/basic/round.hpp"
#include "space/bvh/surface_pieces.hpp"

namespace plumb::space {

/// Always the candidate that holds most of the pieces that none has yet, the first of equal ones; then a smaller sphere
/// around these, where there is one.  What no candidate holds is covered likewise, by spheres of this radius around these
/// pieces.  Each piece is in one of the spheres, and each sphere has one.
/// Source: RTCD 6.4.5; Chvatal 1979 for the greedy cover.
std::vector<Sphere3> pruned_cover(const CoveredPieces& covered, std::span<const Sphere3> candidates, double radius);

}  // namespace plumb::space
