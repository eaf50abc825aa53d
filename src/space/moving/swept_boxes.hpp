// Which boxes contain parts of a moving mesh at every time?  Those around both places: each coordinate lies between its
// two ends.
#pragma once

#include "plumb/space/moving/moving_mesh.hpp"
#include "space/bvh/slot_boxes.hpp"

namespace plumb::space {

inline Aabb3 around_both(const Aabb3& a, const Aabb3& b) {
  return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y), std::min(a.min.z, b.min.z)},
          {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y), std::max(a.max.z, b.max.z)}};
}

inline Aabb3 swept_corner(const MovingMesh& mesh, std::uint32_t i) {
  const Point3 &p = mesh.from[mesh.corners[i]], &q = mesh.to[mesh.corners[i]];
  return box_around(p, q, q);
}
inline Aabb3 swept_edge(const MovingMesh& mesh, std::uint32_t i) {
  const auto [a, b] = mesh.edges[i];
  return around_both(box_around(mesh.from[a], mesh.from[b], mesh.to[a]),
                     box_around(mesh.to[b], mesh.to[b], mesh.to[b]));
}
inline Aabb3 swept_triangle(const MovingMesh& mesh, std::uint32_t i) {
  const Bvh::Corners& c = mesh.triangles[i];
  return around_both(box_around(c, mesh.from), box_around(c, mesh.to));
}

}  // namespace plumb::space
