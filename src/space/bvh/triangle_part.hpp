// Where is a part of a triangle?  A box that certainly contains what of the triangle lies in another box.
//
// Laws: (1) triangle and box have in common what triangle and part_in(triangle, box) have, exactly: so a box stands for
//       a part.  (2) What halves() gives contains together what was in the box: parts of parts cover the triangle.
//       (3) They depend on the triangle and the box alone, so who has the triangle can cut it again.
// A corner within two planes is taken as it is; of where an edge crosses a plane, bounds that are guessed, and that an
// exact predicate finds on their side of the edge.
// Source: Stich, Friedrich, Dietrich 2009, Spatial splits in bounding volume hierarchies.
// Cost: 18 edges against planes; a microsecond where many cross.
#pragma once

#include <array>
#include <optional>

#include "plumb/figure/basic/box.hpp"
#include "plumb/figure/basic/simplex.hpp"

namespace plumb::space {

/// Nothing where they have nothing in common (not always told).
std::optional<Aabb3> part_in(const Triangle3& triangle, const Aabb3& box);

using Halves = std::array<std::optional<Aabb3>, 2>;

/// What is on either side of the middle of the box's longest side; nothing where no double lies between its ends.
std::optional<Halves> halves(const Triangle3& triangle, const Aabb3& box);

}  // namespace plumb::space
