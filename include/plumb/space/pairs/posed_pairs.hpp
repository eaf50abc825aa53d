// Which triangles of a moved mesh meet which of another?  Under poses whose images are not rounded.
//
//   for (const TrianglePair& p : intersecting_pairs({a, pose_a}, {b, pose_b})) use(p.a, p.b, p.relation);
//
// Laws: those of mesh_pairs.hpp, of the exact images (plumb/space/bvh/posed_mesh.hpp).  So two meshes under one pose
// have the pairs that they have without it, each with its relation, where the matrix is regular; and a mesh under such
// a pose those that it has with itself.  What any finds may be another pair than without a pose.
// A pose that is NaN or infinite throws NonFinite ("intersecting_pairs: b.pose.translation.x is nan, ...").
// Source: RTCD 3.2, 4.2.6, 6.3.3; Guigue and Devillers 2003.
// Cost: under one regular pose that of the meshes without it.  Else a box for each node, and some 300 ns for each pair
// of triangles whose boxes meet; some 10 us where one is a segment or a point, and 100 for what a pair has in common.
// Bounded by n^2 tests of pairs, on integers as long as the exponents' span.
#pragma once

#include "plumb/space/bvh/posed_mesh.hpp"
#include "plumb/space/pairs/mesh_pairs.hpp"

namespace plumb {

std::vector<TrianglePair> intersecting_pairs(const PosedMesh& a, const PosedMesh& b, const PairOptions& options = {},
                                             std::vector<TrianglePair> rows = {});
std::vector<TrianglePair> self_intersecting_pairs(const PosedMesh& mesh, const PairOptions& options = {},
                                                  std::vector<TrianglePair> rows = {});

PairCount count_intersecting_pairs(const PosedMesh& a, const PosedMesh& b, const PairOptions& options = {});
PairCount count_self_intersecting_pairs(const PosedMesh& mesh, const PairOptions& options = {});

std::optional<TrianglePair> any_intersecting_pair(const PosedMesh& a, const PosedMesh& b,
                                                  const PairOptions& options = {});
std::optional<TrianglePair> any_self_intersecting_pair(const PosedMesh& mesh, const PairOptions& options = {});

/// What each pair has in common, of the exact images.
std::vector<Intersection3> intersections(const PosedMesh& a, const PosedMesh& b, std::span<const TrianglePair> pairs,
                                         const PairOptions& options = {}, std::vector<Intersection3> rows = {});

/// The same of compact trees.
std::vector<TrianglePair> intersecting_pairs(const PosedCompactMesh& a, const PosedCompactMesh& b,
                                             const PairOptions& options = {}, std::vector<TrianglePair> rows = {});
std::vector<TrianglePair> self_intersecting_pairs(const PosedCompactMesh& mesh, const PairOptions& options = {},
                                                  std::vector<TrianglePair> rows = {});
PairCount count_intersecting_pairs(const PosedCompactMesh& a, const PosedCompactMesh& b,
                                   const PairOptions& options = {});
PairCount count_self_intersecting_pairs(const PosedCompactMesh& mesh, const PairOptions& options = {});
std::optional<TrianglePair> any_intersecting_pair(const PosedCompactMesh& a, const PosedCompactMesh& b,
                                                  const PairOptions& options = {});
std::optional<TrianglePair> any_self_intersecting_pair(const PosedCompactMesh& mesh, const PairOptions& options = {});
std::vector<Intersection3> intersections(const PosedCompactMesh& a, const PosedCompactMesh& b,
                                         std::span<const TrianglePair> pairs, const PairOptions& options = {},
                                         std::vector<Intersection3> rows = {});

}  // namespace plumb
