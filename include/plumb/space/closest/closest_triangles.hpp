// Distance of two meshes: which of their triangles are nearest to one another, and where?
//
//   if (const auto near = closest_triangles(a, b)) use(near->a, near->b, near->closest.distance);
//   closest_triangles(a, b, {.first = true})     // of equally near pairs the first, whatever the trees
//   closest_triangles(a, b, {.within = 0.25})    // no answer where they are farther apart
//   distance(a, {b, pose})                       // the number alone; of a mesh that has been moved
//   within(a, b, 0.25)                           // whether it is at most that: stops where a pair tells
//
// Laws: (1) a pair of least distance in real arithmetic; points, features and distance are those of
// closest_points(triangle a, triangle b) (query/closest/pairs.hpp).  (2) Of equally near pairs any, on the same trees
// the same; with `first` the first by a, then b, which depends on the meshes alone.  (3) A distance of exactly `within`
// is within, and nothing is within a negative one.  (4) Surfaces are asked about: a mesh within a closed one is not at
// distance zero.  (5) Where a mesh is empty there is no pair, the distance is infinite and nothing within.  (6) Under poses
// the answers are those of the exact images (space/bvh/posed_mesh.hpp), of which numbers are rounded once.
// A distance that is NaN throws NonFinite, and so does a pose that is NaN or infinite.
// Source: RTCD 3.2, 4.2.6, 5.1.10, 6.3.2.
// Cost: branch and bound over pairs of nodes, the nearer first; leaves by a way that separates them.  Meshes that meet
// cost about as much as any_intersecting_pair; with `first` that of all pairs that meet or are equally near, thousands
// where faces lie face to face.  Under poses microseconds for each pair of triangles of which doubles say too little.
// Bounded by n^2 log n operations, on integers as long as the exponents' span: each pair at
// most, and their order by distance.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "plumb/query/closest/result.hpp"
#include "plumb/space/bvh/mesh_view.hpp"

namespace plumb {

struct ClosestTriangles {
  std::uint32_t a, b;  // their numbers in the meshes
  Closest closest;
  friend bool operator==(const ClosestTriangles&, const ClosestTriangles&) = default;
};

struct ClosestPairOptions {
  bool first = false;                                       // of equally near pairs
  double within = std::numeric_limits<double>::infinity();  // of no others
};

std::optional<ClosestTriangles> closest_triangles(const BvhView& a, const BvhView& b,
                                                  const ClosestPairOptions& options = {});

double distance(const BvhView& a, const BvhView& b);

bool within(const BvhView& a, const BvhView& b, double distance);

}  // namespace plumb
