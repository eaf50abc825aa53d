// What is a convex polyhedron?  Its faces, and who is beyond which edge.
//
// Laws: made by convex_polyhedron or by a hull, which prove it convex; faces are counterclockwise seen from outside.
// Every vertex is a corner of some face; faces in one plane may stand beside one another.  across[i] is the face beyond
// the edge that leaves corner i of its face; the neighbors of a vertex are listed ascending: the other ends of its
// edges, of each face in whose straight edge it lies a corner off that line, and where all of these are in one plane
// with it one off that plane.  So what lies no less far than its neighbors along a direction lies no less far than any
// vertex.
// Source: RTCD 3.8, 3.8.1, 4.2.5.
// Cost: none.
#pragma once

#include <span>

#include "plumb/figure/basic/body.hpp"
#include "plumb/figure/basic/mesh.hpp"

namespace plumb {

struct ConvexPolyhedron3 {
  PolygonMesh mesh;
  std::vector<std::uint32_t> across;  // one for each of mesh.corners
  std::vector<std::uint32_t> neighbors;
  std::vector<std::uint32_t> first_neighbor{0};  // those of vertex v: neighbors[first_neighbor[v]] up to [.. v + 1]

  [[nodiscard]] std::span<const std::uint32_t> neighbors_of(std::size_t vertex) const {
    return std::span(neighbors).subspan(first_neighbor[vertex], first_neighbor[vertex + 1] - first_neighbor[vertex]);
  }
};

template <class Take>
constexpr auto body(const ConvexPolyhedron3& s, Take take) {
  return take("polyhedron", part::surface("mesh", s.mesh));
}

}  // namespace plumb
