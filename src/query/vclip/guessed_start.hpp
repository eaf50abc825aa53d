// From which vertices does a walk over features begin, where none are given?  Those that lie farthest toward the other
// solid.
//
// Law: a guess in doubles, of which nothing is certain: of numbers that overflow any vertex.
// Source: RTCD 9.5.4 (hill climbing).
// Cost: an addition a vertex, and a climb on each solid.
#pragma once

#include "query/vclip/voronoi_planes.hpp"

namespace plumb::query::vclipping {

MeshFeaturePair guessed_start(const Solid& a, const Solid& b);

}  // namespace plumb::query::vclipping
