// Ray traversal of a k-d tree: which cells does a ray or segment visit, in which order?
//
// A leaf's cell is what its planes leave of space: without end at the border.
// Laws: (1) WalkedCells::closed: each cell whose closed set the ray touches, by a corner, an edge or a wall as well.
// WalkedCells::half_open: points in a plane belong to the upper cell, so that each point of the ray is in one cell, the
// one in which it would be searched for; each cell that holds a point of the ray.  (2) In the order in which they are
// entered, which is that of exact parameters; cells that are entered at once in the order of the descent, nearer
// child first.
// A coordinate that is NaN or infinite throws NonFinite, by name.  A direction of zero leaves the origin.
// Source: RTCD 7.4.1.
// Cost: a comparison of parameters for each plane that is met: of doubles as given for planes of one axis, of certified
// signs for others; no parameter is computed.  Bounded by n comparisons for n cells, on integers as long as the
// exponents' span.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/figure/basic/linear.hpp"
#include "plumb/space/bvh/walked_cells.hpp"
#include "plumb/space/kd_tree/kd_tree.hpp"

namespace plumb {

/// The numbers of the leaves.
std::vector<std::uint32_t> cells_along(const KdTree2& tree, const Segment2& segment,
                                       WalkedCells cells = WalkedCells::closed, std::vector<std::uint32_t> rows = {});
std::vector<std::uint32_t> cells_along(const KdTree2& tree, const Ray2& ray, WalkedCells cells = WalkedCells::closed,
                                       std::vector<std::uint32_t> rows = {});
std::vector<std::uint32_t> cells_along(const KdTree3& tree, const Segment3& segment,
                                       WalkedCells cells = WalkedCells::closed, std::vector<std::uint32_t> rows = {});
std::vector<std::uint32_t> cells_along(const KdTree3& tree, const Ray3& ray, WalkedCells cells = WalkedCells::closed,
                                       std::vector<std::uint32_t> rows = {});

}  // namespace plumb
