// In which order do the triangles at an edge lie around it?
//
// Law: counterclockwise seen from the edge's larger vertex, from the first use on; empty where two lie on one another
// there.
// Source: Zhou et al. 2016, 3.3.
// Cost: n log n signs for n triangles.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "plumb/surface/topology/topology.hpp"

namespace plumb::surface {

std::vector<EdgeUse> order_around_edge(const TriangleMesh& mesh, const std::array<std::uint32_t, 2>& edge,
                                       std::span<const EdgeUse> uses);

}  // namespace plumb::surface
