// Ray cast at constructive solid geometry: where does a ray or a segment first hit a tree of unions, intersections and
// differences?
//
//   const Csg3 nut = (csg(hexagon) & csg(chamfer)) - csg(bore);
//   if (const auto h = first_hit(ray, nut)) ...      // h->hit, and the leaf that it is a feature of
//
// Leaves: halfspaces, slabs, tetrahedra, balls, capsules, cylinders, cones, lozenges, ellipsoids, boxes (AabbCenter3 as
// well), oriented boxes, k-DOPs and convex polyhedra: what a line has one stretch in common with.
// Laws: (1) the set is the closed one of figure/containment/csg.hpp: complements are those of leaves, with their boundary.
// The first t at which the ray is in it is exact (first_hit_parameter), and all numbers are those of query/ray/ray.hpp.
// (2) The hit is that of the leaf that the set begins with there: where the ray enters a leaf, or leaves one that is
// taken away, with the normal the other way round; of several the lowest in the order in which the tree was written.
// (3) A ray that begins in the set hits it at t = 0: on the boundary of the lowest leaf that has the point on its own, or,
// where all leaves together tell that it is inside (locate), in the interior, and of no leaf (`leaf` is leaf_count()).
// A leaf of another kind throws InvalidShape with its number; NaN and infinity throw NonFinite.
// Source: RTCD 2.2.1, 5.3; Roth 1982, "Ray casting for modeling solids".
// Cost: two exact parameters a leaf, some microseconds each; then each of them is looked for in the tree.  Bounded by
// n^2 steps for n leaves, on integers as long as the exponents' span.
#pragma once

#include <cstdint>
#include <optional>

#include "plumb/figure/containment/csg.hpp"
#include "plumb/query/ray/ray.hpp"

namespace plumb {

struct CsgHit {
  Hit hit;
  std::uint32_t leaf;
  friend bool operator==(const CsgHit&, const CsgHit&) = default;
};

std::optional<CsgHit> first_hit(const Ray3& ray, const Csg3& tree);
std::optional<CsgHit> first_hit(const Segment3& segment, const Csg3& tree);
std::optional<RayParameter> first_hit_parameter(const Ray3& ray, const Csg3& tree);
std::optional<RayParameter> first_hit_parameter(const Segment3& segment, const Csg3& tree);
bool hits(const Ray3& ray, const Csg3& tree);
bool hits(const Segment3& segment, const Csg3& tree);

}  // namespace plumb
