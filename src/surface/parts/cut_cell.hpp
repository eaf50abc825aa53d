// What is on each side of a plane that cuts a solid along a notch?  Solids as lists of facets, which are the edges around
// them: no loops are followed, and no facet need be convex, connected or without holes.
//
// A solid, here: what lies below the facets of a cell.  Facets that share a piece of an edge share its vertices, within
// one cell.  A wedge is what lies between two facets that follow one another around an edge, inside the solid.
// Laws: (1) the cells of cut_cell have the volume of the cell, and nothing in common but their boundaries.  (2) A notch
// that lies in the plane, along a facet, is none in any of them; no edge becomes a notch that was none.  (3) The plane
// cuts only where it has to: where its section has no notch on it the solid is left whole, unless another part of
// the section that does would not part the solid then.  (4) So a cut makes at most one more cell for each part of the
// section that has a notch on it; where cavities lie in several boxes of other shells at once, these stay together.
// Source: Chazelle 1984; Bajaj and Dey 1992 for solids with holes and for notches that share vertices.
// Cost: e log e for e edges of the cell, and a sign of each of its vertices; each part of the section passes all edges of
// it, and all other parts.  Bounded by e^2.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "surface/parts/cut_space.hpp"

namespace plumb::surface {

inline constexpr std::uint32_t no_triangle = std::numeric_limits<std::uint32_t>::max();

struct CutEdge {
  std::uint32_t from, to;  // the facet on the left, seen from outside
  CutLine line;
};

struct CutFacet {
  std::uint32_t plane;
  bool turned;             // the solid is above the plane
  bool of_cavity;          // of a shell that lies in another
  std::uint32_t triangle;  // that it is a piece of; no_triangle for what a cut has made
  std::vector<CutEdge> edges;
};

using CutCell = std::vector<CutFacet>;

/// A half plane that ends at an edge, in its plane.  At the edges' direction from the smaller vertex to the larger,
/// with the plane's normal n: side +1 is n x direction, -1 the other.
struct EdgeRay {
  std::uint32_t plane;
  int side;
};

struct EdgeWedge {
  EdgeRay from, to;  // counterclockwise, seen from the larger vertex
  std::uint32_t facet, to_facet;
  bool is_notch;  // of more than half a turn
};

/// An edge, and the wedges at it.
struct WedgedEdge {
  std::uint32_t a, b;  // a is before b
  CutLine line;
  std::uint32_t first, count;  // in CellEdges::wedges
};

struct CellEdges {
  std::vector<WedgedEdge> edges;
  std::vector<EdgeWedge> wedges;
  std::uint32_t notches = 0;
  /// An edge whose facets do not take turns: it is open, or they run against each other or lie on one another.
  std::optional<std::array<std::uint32_t, 2>> flaw;

  [[nodiscard]] std::span<const EdgeWedge> wedges_of(const WedgedEdge& e) const {
    return std::span(wedges).subspan(e.first, e.count);
  }
};

CellEdges edges_of(CutSpace& space, const CutCell& cell);

enum class CutReach : unsigned char {
  notches,     // law 3
  everywhere,  // all of the section
};

std::vector<CutCell> cut_cell(CutSpace& space, CutCell cell, const CellEdges& edges, std::uint32_t plane,
                              CutReach reach = CutReach::notches);

}  // namespace plumb::surface
