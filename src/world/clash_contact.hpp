// Where two surfaces meet, what of each lies in the other, and are both solid on the same side?
//
// Laws: exact.  Only triangles that meet are cut.  Of two solids whose other shells are looked at besides, insides meet
// if and only if one of a_in_b, b_in_a and same_side is true: the border of a common part has a facet of one in the
// other, or one of both with both on the same side.
// What is left of a simple solid without another has a border of facets of the one outside of the other and of the other
// inside of the one.  Where each edge of it has two of them, a piece has a border of its own, so one border is one piece.
// Source: Zhou et al. 2016 (facets and their windings).
// Cost: that of an arrangement of the triangles that meet, and a line through both meshes for each group of facets; for
// pieces all triangles are walked over besides.
#pragma once

#include <optional>
#include <span>

#include "plumb/world/clash.hpp"
#include "world/clash_solids.hpp"

namespace plumb::world {

struct Lying {
  bool a_in_b = false, a_off_b = false;  // facets of a alone: inside of b, outside of it; false where b is a sheet
  bool b_in_a = false, b_off_a = false;
  bool same_side = false;  // facets of both, and two insides beside them
};

/// What two simple solids have in common if their insides meet and each, less the other, is one piece.  Nothing where that
/// is not seen so: in a plane of both, or at an edge with more than two facets around such a rest.  Unless it is gathered,
/// it is empty.
std::optional<InCommon> common_of_one_piece_each(const ClashPart& a, const ClashPart& b,
                                                 std::span<const TrianglePair> pairs, bool gather);

/// The pairs are those of all triangles that meet.
Lying lying_at_contact(const ClashPart& a, const ClashPart& b, std::span<const TrianglePair> pairs);

}  // namespace plumb::world
