// Painter's algorithm, by a BSP tree: in which order do the pieces of polygons stand before an eye?
//
//   for (const std::uint32_t piece : front_to_back(tree, eye)) ...     // tree.pieces[piece].face, tree.corners_of(piece)
//
// Laws: (1) every piece is told once, and none hides a part of one that is told before it: no point of an earlier one
// is seen through an inner point of a later one.  Backward it is the order of painting.  (2) Of leaf-storing trees that
// holds for pieces of different leaves; those of a leaf stand together.
// NaN and infinity throw NonFinite.
// Source: RTCD 8.2.1, 8.2.2; Fuchs, Kedem and Naylor 1980.
// Cost: a sign for each node.  Nothing is searched.
#pragma once

#include "plumb/space/bsp/bsp_tree.hpp"

namespace plumb {

std::vector<std::uint32_t> front_to_back(const BspTree& tree, const Point3& eye, std::vector<std::uint32_t> rows = {});

}  // namespace plumb
