// Dividing triangles at vertices on their edges.
//
// Laws: (1) both sides of an edge are divided, or neither: where a triangle cannot be, all triangles at its edges stay.
// (2) What a triangle becomes covers it, where the vertices are exactly on its edges; else no part is turned over or
// flat.  (3) The order of vertices and triangles changes nothing but the order of what comes out: the parts stand in
// the triangle's place.
// Source: RTCD 12.3.
// Cost: linear but for sorting, and the triangulation of each triangle that is divided.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "surface/repair/steps.hpp"

namespace plumb::surface {

struct EdgeDivision {
  std::array<std::uint32_t, 2> edge;  // ascending
  std::uint32_t vertex;
  friend auto operator<=>(const EdgeDivision&, const EdgeDivision&) = default;
};

enum class OnEdge : unsigned char { exactly, nearly };

struct Divided {
  std::vector<std::uint32_t> parts;  // numbers of the triangles that came of others
  std::vector<EdgeDivision> refused;
};

/// Notes what is divided, not what is refused.
Divided divide_edges(RepairWork& work, std::vector<EdgeDivision> divisions, OnEdge on_edge);

}  // namespace plumb::surface
