// Point in solid, by a BSP tree: inside, outside, or on the boundary?  And in which leaves?
//
//   const BspTree tree = build_bsp(mesh);
//   if (locate(tree, p) == Location::inside) ...
//   leaves_at(tree, p)                    // one, or all that have the point on their borders
//
// Laws: (1) exact: inside where all closed leaves that hold the point are solid, outside where none is, else on the
// boundary.  (2) So it is the answer of locate for the mesh (space/ray/inside.hpp), but that sheets with the solid, or
// nothing, on both sides are no boundary.
// A tree without solid leaves throws InvalidShape, NaN and infinity NonFinite.
// Source: RTCD 8.4.1.
// Cost: a comparison for each plane across an axis, a sign for another; both sides where the point is in a plane.
// Bounded by n^2 signs for n points and n nodes, on integers as long as the exponents' span.
#pragma once

#include "plumb/figure/basic/relation.hpp"
#include "plumb/space/bsp/bsp_tree.hpp"

namespace plumb {

Location locate(const BspTree& tree, const Point3& p);

/// Ascending, of trees of any kind.
std::vector<std::uint32_t> leaves_at(const BspTree& tree, const Point3& p, std::vector<std::uint32_t> rows = {});

}  // namespace plumb
