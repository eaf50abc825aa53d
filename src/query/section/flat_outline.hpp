// Polygon clipping: where does the boundary of what two triangles of one plane have in common run?  Where all areas are
// certain.
//
// It runs along a until a leaves b, then along b until a comes in again.  Which corners lie within, and which edges
// cross, are signs of areas; where no area is zero nothing touches.
// Laws: the corners turn counterclockwise as seen, beginning with the lexicographically smallest: that is where an edge
// that ascends follows one that descends, told by the edges as given.
// Source: RTCD 5.2.10, 5.4.2; O'Rourke and others 1982.
// Cost: 30 to 60 ns.
#pragma once

#include <array>
#include <optional>

#include "plumb/figure/basic/simplex.hpp"

namespace plumb::query {

inline constexpr int no_edge = -1;

/// Corner a of the first triangle (b is no_edge), corner b of the second, or where edge a, from that corner to the
/// next, crosses edge b.
struct OutlineCorner {
  int a, b;
  int a_to = no_edge, b_to = no_edge;  // the corner at the end of the edge
};

struct Outline {
  std::array<OutlineCorner, 6> corners;
  std::size_t count = 0;
};

/// `a_ascends[i][j]`: is corner i smaller than corner j?  None where the triangles are apart; nothing where doubles do
/// not tell.
using Ascending = std::array<std::array<bool, 3>, 3>;
std::optional<Outline> common_outline(const Triangle2& a, const Triangle2& b, const Ascending& a_ascends,
                                      const Ascending& b_ascends);

}  // namespace plumb::query
