// Of two solids whose surfaces meet: the word, what they have in common, and how deep they are in one another.
//
// Source: Zhou et al. 2016 (winding vectors of cells).
// Cost: that of arrange; exact volumes, and hulls of both where it is measured.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "plumb/surface/solid/arrangement.hpp"
#include "plumb/world/clash.hpp"

namespace plumb::world {

/// The arrangement is that of the two meshes.  Fills kind, which is touching where insides do not meet, and inner.
void tell_solids_apart(const Arrangement& of_both, Clash& clash);

/// What two solids have in common, and points that are in both: corners of the first, of the second.
struct InCommon {
  ExactMesh border;  // outward
  std::array<std::vector<Point3>, 2> corners;
};
/// Fills volume and depth, where each part winds by 1, or each by -1, around all that it winds around.
void measure_in_common(const ClashPart& a, const ClashPart& b, const InCommon& common,
                       const std::array<bool, 2>& winds_alike, Clash& clash);

/// Fills volume and depth; their insides meet.
void measure_solids(const ClashPart& a, const ClashPart& b, const Arrangement& of_both, Clash& clash);

/// Into how many pieces does what is marked fall, one number a region?  Pieces are connected by their insides.
std::size_t count_pieces(const Arrangement& arrangement, std::span<const std::uint8_t> is_in);

}  // namespace plumb::world
