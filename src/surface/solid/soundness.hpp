// Does a mesh bound a solid as it is: no triangle without area, no crossing, each point wound around once or not at all?
//
// Laws: as plumb/surface/solid/round.hpp says of a sound mesh; exact.
// Source: RTCD 12.3.
// Cost: that of a tree, of the mesh's pairs with itself, and n log n for edges.
#pragma once

#include "surface/solid/face_pool.hpp"

namespace plumb::surface {

/// Throws as arrange does.
struct Soundness {
  explicit Soundness(const TriangleMesh& mesh);

  TriangleMesh plain;                   // vertices each once; triangles that cancel or lost their corners are gone
  std::vector<std::uint32_t> triangle;  // of the mesh, that each triangle of `plain` was
  std::vector<std::array<std::uint32_t, 2>> meeting;
  bool sound = false;
};

}  // namespace plumb::surface
