// Pairs of boxes by a structure that is made of the first set, or of the only one: grids, octrees, trees of boxes,
// lists.
//
// Laws: those of overlapping_pairs.hpp.  Of two sets, pairs come by the box of the second, then by that of the first.
// Source: RTCD 7.1 to 7.3, 7.5.1.
// Cost: that of the structure, made and asked once.
#pragma once

#include "plumb/space/broad_phase/overlapping_pairs.hpp"
#include "space/sort_and_sweep/swept_set.hpp"

namespace plumb::space {

/// Of boxes that are checked, some in each set; b is empty where there is one set, and else numbered behind a.
template <class Box>
void find_by_index(const BroadPhaseOptions& options, std::span<const Box> a, std::span<const Box> b,
                   const PairTaker& to);

extern template void find_by_index(const BroadPhaseOptions&, std::span<const Aabb2>, std::span<const Aabb2>,
                                   const PairTaker&);
extern template void find_by_index(const BroadPhaseOptions&, std::span<const Aabb3>, std::span<const Aabb3>,
                                   const PairTaker&);

}  // namespace plumb::space
