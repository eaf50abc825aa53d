// How is an exact mesh put in its one order?
//
// Laws: those of ExactMesh; vertices that no triangle names go.
// Source: none.
// Cost: n log n comparisons of numbers.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "plumb/surface/solid/exact_mesh.hpp"

namespace plumb::surface {

/// The vertices ascend.
ExactMesh mesh_in_order(std::span<const ExactPoint3> vertices,
                        std::vector<std::pair<TriangleMesh::Triangle, SourceFace>> triangles);
/// The same for vertices that nobody needs after it: none is copied.
ExactMesh mesh_in_order(std::vector<ExactPoint3>&& vertices,
                        std::vector<std::pair<TriangleMesh::Triangle, SourceFace>> triangles);

}  // namespace plumb::surface
