// How many faces of a mesh are no plane polygons, taken by their coordinates?
//
// A file that says "these four points are one face" and gives points of no common plane contradicts itself; decimals
// do that to most slanted faces.
// Law: exact.
// Source: RTCD 12.4.2.
// Cost: one orient3d a corner beyond the third.
#pragma once

#include <cstdint>

#include "plumb/figure/basic/mesh.hpp"

namespace plumb::tool {

std::uint64_t bent_faces(const PolygonMesh& mesh);

}  // namespace plumb::tool
