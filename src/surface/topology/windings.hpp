// Can the triangles of a component be turned so that they agree, and which are to be turned?
//
// Components are those over edges of exactly two triangles, numbered by their first triangles; one that names a vertex
// twice is alone.
// Law: of an orientable component all triangles agree where those that are `against` are turned, and its first is not
// against; else nothing is said of them.
// Source: RTCD 12.3.
// Cost: linear.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/surface/topology/components.hpp"

namespace plumb::surface {

struct Windings {
  Components components;
  std::vector<std::uint8_t> against;     // of each triangle: wound against its component's first
  std::vector<std::uint8_t> orientable;  // of each component
};

Windings find_windings(const TriangleMesh& mesh, const MeshEdges& edges);

}  // namespace plumb::surface
