// Of two solids whose surfaces meet: the word, what they have in common, and how deep they are in one another.
//
// Source: Zhou et al. 2016 (winding vectors of cells).
// Cost: that of arrange; exact volumes, and hulls of both where it is measured.
#pragma once

#include <span>

#include "plumb/surface/solid/arrangement.hpp"
#include "plumb/world/clash.hpp"

namespace plumb::world {

/// The arrangement is that of the two meshes.  Fills kind, which is touching where insides do not meet, and inner.
void tell_solids_apart(const Arrangement& of_both, Clash& clash);

/// Fills volume and depth; their insides meet.
void measure_solids(const ClashPart& a, const ClashPart& b, const Arrangement& of_both, Clash& clash);

/// Into how many pieces does what is marked fall, one number a region?  Pieces are connected by their insides.
std::size_t count_pieces(const Arrangement& arrangement, std::span<const std::uint8_t> is_in);

}  // namespace plumb::world
