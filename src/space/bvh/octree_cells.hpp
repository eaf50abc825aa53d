// Which cells of an octree does a surface meet, level by level?
//
// Laws: (1) a cell of a level is there exactly if a triangle meets it and all cells that it is part of; the halves of a
// cell cover it, for they share a face of doubles.  (2) `least` of a cell is a box that holds all of the surface in it:
// of each triangle its box's part in the cell.
// Source: RTCD 6.4.3.
#pragma once

#include <vector>

#include "plumb/space/bvh/bvh.hpp"

namespace plumb::space {

struct OctreeCells {
  std::vector<std::vector<std::uint32_t>> children;  // of each cell of each level but the last
  std::vector<Aabb3> least;                          // of the last level's cells
  double side = 0;                                   // of a cell of the last level; a guess
};

OctreeCells octree_cells(const Bvh& mesh, std::uint32_t levels);

}  // namespace plumb::space
