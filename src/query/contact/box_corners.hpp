// Where are the corners of a contact of two boxes, and how far apart?  Four at once, by pairs of doubles in lanes.
//
// Laws: what is told is exact, then rounded; what is left open is not told.  Nothing is told but of boxes as they stand, a
// side of each, and on processors without lanes of four.
// Source: query/contact/corner_numbers.hpp; RTCD 13.7.
// Cost: some 250 operations a side, 350 more where corners of it are told, 500 for each four edges that cross; no
// allocation.
#pragma once

#include "query/contact/told_numbers.hpp"

namespace plumb::query::touching {

using QuickCorners = parting::ShortList<std::optional<Corner>, 8>;

/// Of those that were found, one each in `to`.  `is_zero`: which numbers of the normal are none, as far as that is known.
void tell_box_corners(const Pair& pair, const Matched& m, const Whole& whole, const std::array<bool, 3>& is_zero,
                      QuickCorners& to);

}  // namespace plumb::query::touching
