// Bounding volume (AABB): which min-max, min-widths or center-radius box is the same axis-aligned box, or the least
// that holds it?
//
// Laws: (1) the result contains the box, exactly; it is the same set wherever doubles can say it in the new form, with
// the corner or center named here.  (2) A corner is the double nearest outward; widths are the least that reach from
// that corner; a center is the double nearest to the middle, and half extents are the least that reach from it: no
// other center needs less.  (3) A box in its own form keeps its numbers, widths and half extents as magnitudes.
// An empty box has no widths and no half extents and throws InvalidShape, a number that no double holds throws
// BeyondDoubles; NaN and infinities throw NonFinite.
// Source: RTCD 4.2 (figure 4.3), 4.2.1.
// Cost: some 20 ns a number; about 1 us where pairs of doubles leave a choice.  Nothing is searched.
#pragma once

#include "plumb/arith/error.hpp"
#include "plumb/figure/basic/box.hpp"

namespace plumb {

Aabb3 to_aabb(const Aabb3& box);
Aabb3 to_aabb(const AabbWidths3& box);
Aabb3 to_aabb(const AabbCenter3& box);

AabbWidths3 to_aabb_widths(const Aabb3& box);
AabbWidths3 to_aabb_widths(const AabbWidths3& box);
AabbWidths3 to_aabb_widths(const AabbCenter3& box);

AabbCenter3 to_aabb_center(const Aabb3& box);
AabbCenter3 to_aabb_center(const AabbWidths3& box);
AabbCenter3 to_aabb_center(const AabbCenter3& box);

}  // namespace plumb
