// What answered last time may answer again: queries that begin at the triangles of their last answer.
//
//   LastPair last;                                    // one for each two meshes that are asked again and again
//   for (;;) if (any_intersecting_pair(a, b, last)) ...
//   LastTriangle near;                                // one for each ray, one for each point
//   any_hit(mesh, ray, near);
//
// Laws: (1) the answers are those of the functions without a memory, exactly; any_intersecting_pair may name another of
// the pairs that meet, closest_triangles another of equally near ones where the first is not asked for.  (2) What is
// remembered is a guess that is tested: it may be of a mesh that has been moved, refitted, built anew or is another
// one.  (3) It is written by each query: two threads need two.
// Errors are those of the functions without a memory.
// Source: RTCD 6.7.1.
// Cost: two numbers; a triangle's test, or that of a pair, where the guess is wrong.  Where it is right, whether meshes
// meet and whether a ray hits is known by it alone; of what is nearest those triangles are left out that the search
// would try before it comes to it, which counts where meshes are posed.  (A guess of what a ray hits first saves
// nothing: the search comes there at once.)  Bounded by the search that has no memory, and one test: n^2 log n
// operations of two meshes, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <optional>

#include "plumb/space/closest/closest_on_mesh.hpp"
#include "plumb/space/closest/closest_triangles.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"
#include "plumb/space/ray/mesh_ray.hpp"

namespace plumb {

/// A place in a tree; none at first.
struct LastTriangle {
  std::uint32_t slot = no_triangle;
};
struct LastPair {
  std::uint32_t slot_a = no_triangle, slot_b = no_triangle;
};

std::optional<TrianglePair> any_intersecting_pair(const BvhView& a, const BvhView& b, LastPair& last,
                                                  const PairOptions& options = {});

std::optional<ClosestOnMesh> closest_on_mesh(const BvhView& mesh, const Point3& p, LastTriangle& last);

std::optional<ClosestTriangles> closest_triangles(const BvhView& a, const BvhView& b, LastPair& last,
                                                  const ClosestPairOptions& options = {});

bool any_hit(const Bvh& bvh, const AnyRay& ray, LastTriangle& last, HitRule rule = HitRule::closed);

}  // namespace plumb
