// Which filling of a loop has the least area, and is there another one that has no more?
//
// Laws: (1) of all triangulations on the loop's corners without new vertices, of triangles that have area each, without
// diagonals that `is_taken` names, one of exactly least area: bounds that intervals carry tell it apart from the others,
// and where they overlap sums of roots are compared exactly.  (2) `tied` where another one, which is not the same surface,
// has exactly that area.  Where they are the same surface (other diagonals in one plane, of one outline by the same
// edges) the loop's order decides.  (3)
// The same loop, from its first point on (point_order.hpp), has the same filling, however its vertices are numbered.
// Source: RTCD 12.5.1; Barequet and Sharir 1995; Klincsek 1980.
// Cost: n^3 intervals, and n^2 words.  Bounded by n^4 roots of integers as long as the exponents' span, where all
// fillings are equally large.
#pragma once

#include "surface/repair/loop_filling.hpp"

namespace plumb::surface {

struct LeastArea {
  Filling filling;
  bool tied = false;
};

/// Nothing where there is no filling.
std::optional<LeastArea> least_area_filling(std::span<const Point3> points, std::span<const std::uint32_t> loop,
                                            const TakenDiagonal& is_taken);

}  // namespace plumb::surface
