// Where does a plane cut a cell: what of each facet lies above and below, and of which parts does the section consist?
//
// Laws: (1) the halves of a facet that crosses the plane are closed along it.  (2) Section edges have the section on
// their left, seen from below, as the bottom of what lies above has it; where an edge of the cell lies in the plane with
// solid on both sides, it is there twice.  (3) Parts hang together by vertices, or lie in one another's boxes: they may
// be fewer than there are, never more.
// Source: Chazelle 1984.
// Cost: a sign for each vertex, e log e for e edges in the plane; the square of the vertices that a facet has in it, and
// of the pieces of the section that share no vertex.
#pragma once

#include "surface/parts/cut_cell.hpp"
#include "surface/topology/disjoint_sets.hpp"

namespace plumb::surface {

struct SplitFacet {
  bool has_above = false, has_below = false;
  std::vector<CutEdge> above, below;   // without what is closed along the plane
  std::vector<std::uint32_t> closing;  // section edges, of a facet that crosses the plane
};

struct SectionEdge {
  CutEdge edge;
  bool at_notch;  // of the cell, in the plane
  std::uint32_t part = 0;
  std::uint32_t facet = no_triangle;  // that crosses the plane there
};

struct CutSection {
  std::vector<SplitFacet> facets;
  std::vector<SectionEdge> edges;
  std::uint32_t parts = 0;
  std::vector<std::uint32_t> is_needed;  // of each part: a notch is on it
};

class CutSplitter {
 public:
  CutSplitter(CutSpace& space, const CutCell& cell, const CellEdges& edges, std::uint32_t plane);
  CutSection find();
  /// The vertex is one of the cell or of the section.
  [[nodiscard]] Sign side(std::uint32_t vertex);

 private:
  void split(std::uint32_t facet);
  void split_edge(const CutFacet& facet, const CutEdge& edge, SplitFacet& halves);
  void close(std::uint32_t facet);
  void take_edges_in_plane();
  void find_parts();

  CutSpace& space_;
  const CutCell& cell_;
  const CellEdges& edges_;
  std::uint32_t plane_;
  std::unordered_map<std::uint32_t, Sign> side_of_;
  CutSection found_;
};

}  // namespace plumb::surface
