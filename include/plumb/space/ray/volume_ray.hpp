// Ray cast against a mesh by a tree of spheres, oriented boxes or k-DOPs: which triangle first, is any hit?
//
//   const auto spheres = build_volume_tree<Sphere3>(bvh);
//   if (const auto hit = first_hit(VolumeMesh{bvh, spheres}, Ray3{eye, direction})) ...
//   const PosedMesh moved{bvh, pose};
//   const auto around = posed_volume_tree(moved, spheres);
//   any_hit(VolumeMesh{moved, around}, ray)
//
// Laws: the answers are those of mesh_ray.hpp, whatever the volumes: a volume is left out where
// intervals that contain every real result prove that the ray does not meet it, or not before a triangle that is hit.
// Of a tree that does not enclose its mesh nothing is promised; one whose shape is another's throws InvalidShape.  A ray
// or a pose that is NaN or infinite throws NonFinite.
// Source: RTCD 5.3.2, 5.3.3, 6.3.2, 6.4.
// Cost: three slabs for each oriented box that is looked at, a discriminant for each sphere, a slab for each direction
// of a k-DOP, all in intervals; a mesh's own tree of boxes is faster for single rays (docs/trees.md).  Bounded by n
// tests of volumes and of triangles a ray, on integers as long as the exponents' span.
#pragma once

#include "plumb/query/ray/batch.hpp"
#include "plumb/space/bvh/volume_mesh.hpp"

namespace plumb {

/// Of the volumes Sphere3, Aabb3, Obb3 and KDop3.
template <class Volume>
std::optional<NumberedHit> first_hit(const VolumeMesh<Volume>& mesh, const AnyRay& ray, HitRule rule = HitRule::closed);

template <class Volume>
bool any_hit(const VolumeMesh<Volume>& mesh, const AnyRay& ray, HitRule rule = HitRule::closed);

}  // namespace plumb
