// Which volumes stand for a mesh's boxes in a question?  A mesh and a tree of volumes around it.
//
//   intersecting_pairs(VolumeMesh{mesh_a, a}, VolumeMesh{mesh_b, b})     // pairs/volume_pairs.hpp
//   first_hit(ray, VolumeMesh{PosedMesh{mesh_a, pose}, a_moved})         // ray/volume_ray.hpp
//
// Source: RTCD 6.4.
// Cost: none.
#pragma once

#include "plumb/space/bvh/volume_tree.hpp"

namespace plumb {

/// A mesh, or one that has been moved, and volumes around its exact image; both must outlive it.
template <class Volume>
struct VolumeMesh {
  PosedMesh mesh;
  const VolumeTree<Volume>& volumes;

  VolumeMesh(const PosedMesh& m, const VolumeTree<Volume>& v) : mesh(m), volumes(v) {}
  VolumeMesh(const Bvh& m, const VolumeTree<Volume>& v) : mesh(m), volumes(v) {}
  VolumeMesh(const PosedMesh&, VolumeTree<Volume>&&) = delete;  // which would not live
  VolumeMesh(const Bvh&, VolumeTree<Volume>&&) = delete;
};

}  // namespace plumb
