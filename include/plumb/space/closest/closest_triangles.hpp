// Distance of two meshes: which of their triangles are nearest to one another, and where?
//
//   if (const auto near = closest_triangles(a, b)) use(near->a, near->b, near->closest.distance);
//
// Laws: (1) the pair of least distance in real arithmetic, of equally near ones the first by a, then b; points, features
// and distance are those of closest_points(triangle a, triangle b) (query/closest/pairs.hpp).  (2) It depends on the
// meshes alone, not on their trees.  (3) Surfaces are asked about: a mesh within a closed one is not at distance zero.
// (4) Where a mesh is empty there is no pair.
// Source: RTCD 5.1.10, 6.3.2.
// Cost: branch and bound over pairs of nodes, always the nearest; for meshes that meet that of all pairs that may
// (whoever asks no more than whether they do is served by any_intersecting_pair).  Bounded by n^2 log n operations, on
// integers as long as the exponents' span: each pair at most, and their order by distance.
#pragma once

#include <cstdint>
#include <optional>

#include "plumb/query/closest/result.hpp"
#include "plumb/space/bvh/bvh.hpp"

namespace plumb {

struct ClosestTriangles {
  std::uint32_t a, b;  // their numbers in the meshes
  Closest closest;
  friend bool operator==(const ClosestTriangles&, const ClosestTriangles&) = default;
};

std::optional<ClosestTriangles> closest_triangles(const Bvh& a, const Bvh& b);

}  // namespace plumb
