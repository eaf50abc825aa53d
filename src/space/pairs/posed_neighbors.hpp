// Have two triangles of one mesh more in common than the vertices that they share, when a pose has flattened them?
//
// Beside a shared vertex both are cones, of the ways to their other corners; in a plane two cones have a way in common
// where one of these ways is in the other cone.
// Law: relate_in_mesh (plumb/space/pairs/neighbors.hpp) of the exact images, under a pose whose matrix is singular, so
// that they lie in one plane.
// Cost: microseconds.
#pragma once

#include "plumb/figure/basic/relation.hpp"
#include "plumb/space/bvh/posed_mesh.hpp"

namespace plumb::space {

Relation relate_flattened(std::span<const Point3> vertices, const Bvh::Corners& a, const Bvh::Corners& b,
                          const Pose& pose);

}  // namespace plumb::space
