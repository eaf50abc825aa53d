// Does a mesh bound a solid, and which of its shells belong together?
//
// Laws: (1) the mesh that is told has each point once, its vertices and triangles ascending: whatever follows from it
// alone does not hang on the order of what was given.  (2) Groups are an outer shell each and the cavities in it.
// Source: RTCD 12.3; plumb/surface/topology/shells.hpp.
// Cost: that of find_shells.
#pragma once

#include "plumb/figure/basic/mesh.hpp"
#include "surface/parts/cut_cell.hpp"

namespace plumb::surface {

struct SoundSolid {
  TriangleMesh mesh;
  std::vector<std::uint32_t> given;  // each triangle's number as it was
};

/// Throws InvalidShape or NonFinite for what can be said without a look at pairs of triangles.
SoundSolid in_canonical_order(const char* question, const TriangleMesh& mesh);

/// The cells of the mesh; throws InvalidShape where they are no solids.
std::vector<CutCell> solids_of(const char* question, const SoundSolid& solid, CutSpace& space);

}  // namespace plumb::surface
