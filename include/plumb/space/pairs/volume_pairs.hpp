// Which triangles of two meshes meet, by trees of spheres, oriented boxes or k-DOPs?
//
//   const auto a = build_volume_tree<Obb3>(mesh_a), b = build_volume_tree<Obb3>(mesh_b);
//   intersecting_pairs(VolumeMesh{mesh_a, a}, VolumeMesh{mesh_b, b});
//   const PosedMesh moved{mesh_a, pose};
//   const auto a_moved = posed_volume_tree(moved, a);
//   intersecting_pairs(VolumeMesh{moved, a_moved}, VolumeMesh{mesh_b, b});
//   pair_work(...)        // how many tests of volumes and triangles that takes
//
// Laws: the answers are those of intersecting_pairs without volumes (mesh_pairs.hpp), whatever the
// volumes.  Of a tree that is not one of its mesh, or that does not enclose it, nothing is promised; the first throws
// InvalidShape where its shape tells.
// Source: RTCD 6.1.2, 6.3.3, 6.4.
// Cost: N_v C_v + N_p C_p, of which pair_work says N_v and N_p.  Bounded by n^2 tests of volumes and of triangles, on
// integers as long as the exponents' span.
#pragma once

#include "plumb/space/bvh/volume_mesh.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"

namespace plumb {

/// Of the volumes Sphere3, Aabb3, Obb3 and KDop3; k-DOPs of the same directions.
template <class Volume>
std::vector<TrianglePair> intersecting_pairs(const VolumeMesh<Volume>& a, const VolumeMesh<Volume>& b,
                                             const PairOptions& options = {}, std::vector<TrianglePair> rows = {});

template <class Volume>
std::optional<TrianglePair> any_intersecting_pair(const VolumeMesh<Volume>& a, const VolumeMesh<Volume>& b,
                                                  const PairOptions& options = {});

struct PairWork {
  std::size_t volume_tests = 0;    // N_v: pairs of volumes that were compared
  std::size_t leaf_pairs = 0;      // of them those of leaves that met
  std::size_t triangle_pairs = 0;  // N_p: pairs of triangles in these leaves
  std::size_t pairs = 0;           // that meet; of a split mesh (BvhOptions) each as often as its slots do
  friend bool operator==(const PairWork&, const PairWork&) = default;
};

/// Of intersecting_pairs on one thread.
template <class Volume>
PairWork pair_work(const VolumeMesh<Volume>& a, const VolumeMesh<Volume>& b);

}  // namespace plumb
