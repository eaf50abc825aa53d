// Portal rendering, potentially visible sets: which cells are seen from a place, or from anywhere in a cell, through
// which portals?
//
//   const Sight sight = seen_from(rooms, cell, eye);               // or with a window, through that
//   sight.cells                                                    // ascending; the first one's own is among them
//   sight.chains[k].portals, .cell, .window                        // what of the last portal is seen, exactly
//   potentially_visible(rooms, cell).cells
//
// Laws: (1) seen_from: a chain of portals is told exactly where a segment from the eye to a place of the last one goes
// through all of them in their order; `window` is the set of these places, a convex polygon, which may be a segment or
// a point.  Each portal is seen from its near side: the eye is strictly on that side of its plane, or, of the first, on
// it.  What is edge-on shows nothing.  (2) potentially_visible misses nothing: each chain that is seen from some place
// of the cell is told.  Of a chain of two portals or three it tells no others, as far as what only touches counts as
// seen; a longer one is told where what each two of them let through meets the last.  (3) No cell comes twice in a
// chain: what is convex is not left and entered again.  (4) Chains are told depth first, portals of a cell by their
// numbers.
// An eye outside the cell, and a window that is no convex polygon or edge-on, throw InvalidShape; NaN and infinity
// NonFinite.
// Source: RTCD 7.6; Luebke and Georges 1995; separating planes of pairs of portals: Teller and Sequin 1991.
// Cost: a clip of the last portal by each edge of those before it, exactly, on points that planes of given points
// construct (docs/implicit_points.md); for potentially_visible by each plane that separates two.  No recursion.  Chains
// may be many where portals are large: as many as are seen.  Bounded by n^2 clips for a chain of n portals
// and those that it begins with, on integers as long as the exponents' span.
#pragma once

#include "plumb/certify/exact_point.hpp"
#include "plumb/space/cells/portal_cells.hpp"

namespace plumb {

struct SeenChain {
  std::vector<std::uint32_t> portals;  // from the first cell on
  std::uint32_t cell;                  // behind the last
  std::vector<ExactPoint3> window;     // what of the last is seen
};

struct Sight {
  std::vector<std::uint32_t> cells;
  std::vector<SeenChain> chains;
};

Sight seen_from(const PortalCells& rooms, std::uint32_t cell, const Point3& eye);
Sight seen_from(const PortalCells& rooms, std::uint32_t cell, const Point3& eye, const Polygon3& window);

Sight potentially_visible(const PortalCells& rooms, std::uint32_t cell);

}  // namespace plumb
